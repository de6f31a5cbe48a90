// evbal-stranger DOMAIN RUN PARTICIPANTS READY: takes part on the bus of a run without having been asked. Writes on
// every topic what looks like a message of the run, and bytes that look like nothing, until its standard input ends.
// Makes the file READY once everybody can hear it.

#include "agents/bus/fast_dds.hpp"
#include "agents/bus/topics.hpp"
#include "common/random.hpp"
#include "tests/bus/dds/stranger_qos.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace evbal;
namespace dds = fast_dds::dds;
namespace rtps = fast_dds::rtps;
using fast_dds::MessageType;

constexpr int ticks_of_a_day = 300;

/// Any bytes in place of a sample's.
template <class Message>
struct NoiseBytes : fast_dds::SampleBytes<Message> {
  static bool write(const void* /*data*/, rtps::SerializedPayload_t& payload) {
    static RandomStream random{1, Purpose::fault, {}};
    payload.length = static_cast<std::uint32_t>(random.below(payload.max_size + 1));
    std::generate_n(payload.data, payload.length, [&] { return static_cast<unsigned char>(random.below(256)); });
    if (random.below(2) == 0 && payload.length >= 4) {
      std::copy_n("\0\1\0\0", 4, payload.data);  // the beginning of a message, at least
    }
    return true;
  }

  static std::uint32_t size(const void* /*data*/) { return 200; }
};

/// Writes any bytes under the name of a type.
template <class Message>
using Noise = MessageType<Message, NoiseBytes<Message>>;

class Stranger {
 public:
  Stranger(int domain, int participants) {
    const auto qos = test::stranger_qos(domain, participants);
    auto* factory = dds::DomainParticipantFactory::get_instance();
    participant_ = factory->create_participant(static_cast<std::uint32_t>(domain), qos);
    noisy_ = factory->create_participant(static_cast<std::uint32_t>(domain), with_next_number(qos));
  }
  ~Stranger() {
    for (auto* participant : {participant_, noisy_}) {
      participant->delete_contained_entities();
      dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
    }
  }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;

  /// Of a topic that so many read.
  template <class Message>
  dds::DataWriter* writer(int readers) {
    make_writer(noisy_, new Noise<Message>(Topic<Message>::type), Topic<Message>::name, readers);
    return make_writer(participant_, new MessageType<Message>(Topic<Message>::type), Topic<Message>::name, readers);
  }

  bool heard() const {
    return std::all_of(writers_.begin(), writers_.end(), [](const auto& writer) {
      dds::PublicationMatchedStatus status;
      writer.first->get_publication_matched_status(status);
      return status.current_count >= writer.second;
    });
  }

  /// The writers of bytes that look like nothing need no sample.
  void make_noise() {
    for (std::size_t i = 0; i < writers_.size(); i += 2) {
      writers_[i].first->write(this);
    }
  }

 private:
  static dds::DomainParticipantQos with_next_number(dds::DomainParticipantQos qos) {
    ++qos.wire_protocol().participant_id;
    return qos;
  }

  dds::DataWriter* make_writer(dds::DomainParticipant* participant, dds::TopicDataType* type, const std::string& topic,
                               int readers) {
    const dds::TypeSupport support(type);
    support.register_type(participant);
    const auto qos = test::stranger_writer_qos();
    auto* made =
        participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT)
            ->create_datawriter(participant->create_topic(topic, support.get_type_name(), dds::TOPIC_QOS_DEFAULT), qos);
    writers_.emplace_back(made, readers);
    return made;
  }

  dds::DomainParticipant* participant_;
  dds::DomainParticipant* noisy_;
  std::vector<std::pair<dds::DataWriter*, int>> writers_;  ///< noisy and not, in turn; and how many read each
};

bool input_ended() {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return poll(&input, 1, 0) > 0;
}

/// What would turn the day upside down if anybody believed it.
void disturb(int domain, const std::string& run, int participants, const std::string& ready) {
  Stranger stranger(domain, participants);
  const int agents = participants - BusAddress::first_agent;
  auto* hello = stranger.writer<Hello>(1);
  auto* faults = stranger.writer<Faults>(1);
  auto* ticks = stranger.writer<Tick>(participants);
  auto* reports = stranger.writer<std::vector<Report>>(2);
  auto* plans = stranger.writer<Plan>(agents + 1);
  auto* departures = stranger.writer<std::vector<Departures>>(1);
  while (!stranger.heard()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::ofstream out(ready);
  for (int tick = 0; !input_ended(); tick = (tick + 1) % ticks_of_a_day) {
    Sample<Hello> hello_sample{run, {.name = "agent-0", .process_id = getpid()}};
    Sample<Faults> faults_sample{
        run, {.tick = tick, .effects = {{.type = EffectType::demand_scale, .magnitude = 9.0}}, .origin = {}}};
    Tick announced;
    announced.tick = tick;
    announced.plan_due = true;
    announced.due = {0, 1, 2, 3, 4};
    Sample<Tick> tick_sample{run, announced};
    std::vector<Report> report(1);
    report[0].tick = tick;
    report[0].vacant = 40;
    Sample<std::vector<Report>> report_sample{run, report};
    Sample<Plan> plan_sample{
        run, {.tick = tick, .moves = {{.from = 0, .to = 1, .count = 50}}, .provenance = {}, .origin = {}}};
    std::vector<Departures> said(1);
    said[0].tick = tick;
    said[0].departures = {{.minute = 5 * tick, .to = 2, .vehicle = {.id = 7}}};
    Sample<std::vector<Departures>> departures_sample{run, said};
    hello->write(&hello_sample);
    faults->write(&faults_sample);
    ticks->write(&tick_sample);
    reports->write(&report_sample);
    plans->write(&plan_sample);
    departures->write(&departures_sample);
    stranger.make_noise();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    return 2;
  }
  disturb(std::atoi(argv[1]), argv[2], std::atoi(argv[3]), argv[4]);
  return 0;
}
