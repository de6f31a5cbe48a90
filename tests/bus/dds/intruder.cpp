// evbal-intruder DOMAIN RUN PARTICIPANTS READY [KEYS]: tries to take part on the bus of a run with security, with what
// is in the folder KEYS (agents/bus/keys.hpp) or with nothing. Writes plans, and reports and departures of region 0, as
// far as it is let, until its standard input ends. Makes the file READY once it writes.

#include "agents/bus/fast_dds.hpp"
#include "agents/bus/keys.hpp"
#include "agents/bus/topics.hpp"
#include "tests/bus/dds/stranger_qos.hpp"

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace evbal;
namespace dds = fast_dds::dds;

constexpr int ticks_of_a_day = 300;

dds::DomainParticipant* join(int domain, int participants, const std::string& keys) {
  auto qos = test::stranger_qos(domain, participants);
  qos.name("intruder");
  if (!keys.empty()) {
    for (const auto& [name, value] : security_properties(keys)) {
      qos.properties().properties().emplace_back(name, value);
    }
  }
  return dds::DomainParticipantFactory::get_instance()->create_participant(static_cast<std::uint32_t>(domain), qos);
}

/// Null if the middleware of this process refuses already, as an honest one does without the grant.
template <class Message>
dds::DataWriter* writer(dds::DomainParticipant* participant) {
  const dds::TypeSupport type(new fast_dds::MessageType<Message>(Topic<Message>::type));
  type.register_type(participant);
  auto* topic = participant->create_topic(Topic<Message>::name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  return participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT)
      ->create_datawriter(topic, test::stranger_writer_qos());
}

template <class Message>
void write(dds::DataWriter* writer, const std::string& run, const Message& message) {
  if (writer != nullptr) {
    Sample<Message> sample{run, message};
    writer->write(&sample);
  }
}

bool input_ended() {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return poll(&input, 1, 0) > 0;
}

/// What would turn the day upside down if anybody believed it.
void disturb(dds::DomainParticipant* participant, const std::string& run, const std::string& ready) {
  auto* plans = writer<Plan>(participant);
  auto* reports = writer<std::vector<Report>>(participant);
  auto* departures = writer<std::vector<Departures>>(participant);
  std::ofstream(ready) << "writes\n";
  for (int tick = 0; !input_ended(); tick = (tick + 1) % ticks_of_a_day) {
    write(plans, run, Plan{.tick = tick, .moves = {{.from = 0, .to = 1, .count = 50}}, .provenance = {}, .origin = {}});
    std::vector<Report> report(1);
    report[0].tick = tick;
    report[0].vacant = 40;
    write(reports, run, report);
    std::vector<Departures> said(1);
    said[0].tick = tick;
    said[0].departures = {{.minute = 5 * tick, .to = 2, .vehicle = {.id = 7}}};
    write(departures, run, said);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  participant->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5 || argc > 6) {
    return 2;
  }
  auto* participant = join(std::atoi(argv[1]), std::atoi(argv[3]), argc == 6 ? argv[5] : "");
  if (participant == nullptr) {
    return 1;
  }
  disturb(participant, argv[2], argv[4]);
  return 0;
}
