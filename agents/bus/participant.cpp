#include "agents/bus/participant.hpp"

#include "agents/bus/bus_listener.hpp"
#include "agents/bus/fast_dds.hpp"
#include "agents/bus/inbox.hpp"
#include "agents/bus/keys.hpp"
#include "agents/bus/ports.hpp"
#include "agents/bus/roster.hpp"
#include "agents/bus/surroundings.hpp"
#include "agents/bus/topics.hpp"
#include "common/error.hpp"

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace evbal {
namespace {

using namespace fast_dds;

constexpr std::uint32_t socket_buffer = 4 * 1024 * 1024;
constexpr std::uint32_t packet_bytes = 16 * 1024;     // every process holds some buffers of so many
constexpr std::uint32_t packet_bytes_apart = 1400;    // one packet of a network, any of which can be lost
constexpr int most_in_buffers = 128;                  // participants whose samples all fit into any socket's buffer
constexpr std::uint32_t answer_ns_apart = 1'000'000;  // to who says that something is missing, or by whom it is missed
constexpr std::uint32_t first_announcements = 4;
constexpr std::uint32_t ns_a_ms = 1'000'000;
constexpr int first_announcements_ms = 250;
constexpr int announcements_ms = 1000;
constexpr int announcements_ms_a_head = 12;
constexpr int kept_samples = 16;  // of reports and departures, for readers that are a little behind

template <class Entity>
Entity* made(Entity* entity, const std::string& what) {
  if (entity == nullptr) {
    throw run_failed("Fast DDS could not make " + what);
  }
  return entity;
}

/// Where this participant is, or one for which it looks.
std::string host_of(const BusAddress& address, int participant) {
  if (address.apart) {
    return address_of_host(std::max(0, participant - BusAddress::first_agent + 1));
  }
  return participant == address.participant ? address.host : address.launcher;
}

rtps::Locator_t locator_of(const BusAddress& address, int participant) {
  rtps::Locator_t locator;
  locator.kind = LOCATOR_KIND_UDPv4;
  IPLocator::setIPv4(locator, host_of(address, participant));
  locator.port = static_cast<std::uint32_t>(discovery_port(address.domain, participant));
  return locator;
}

void use_own_host_only(dds::DomainParticipantQos& qos, const BusAddress& address) {
  const std::string host = host_of(address, address.participant);
  if (!is_own_address(host)) {
    throw run_failed("address " + host +
                     ": no network interface of this machine has it; `ip address` shows those that do");
  }
  qos.transport().use_builtin_transports = false;
  const auto udp = std::make_shared<UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {host};
  udp->maxMessageSize = address.apart ? packet_bytes_apart : packet_bytes;
  if (address.participant < BusAddress::first_agent) {
    udp->sendBufferSize = socket_buffer;
    udp->receiveBufferSize = socket_buffer;
  }
  qos.transport().user_transports.push_back(udp);
  rtps::Locator_t own = locator_of(address, address.participant);
  qos.wire_protocol().builtin.metatrafficUnicastLocatorList.push_back(own);
  ++own.port;
  qos.wire_protocol().default_unicast_locator_list.push_back(own);
}

/// Whom a participant looks for; these answer at once. The conductor is on the bus before the others and is looked for
/// by all of them. A coordinator that returns finds its agents there, who would meet it at their next announcement
/// only; so they do if they are on several hosts, among which they may have moved.
std::vector<int> peers_of(const BusAddress& address) {
  switch (address.participant) {
    case BusAddress::conductor:
      return {BusAddress::coordinator, BusAddress::injector};
    case BusAddress::injector:
      return {BusAddress::conductor};
    case BusAddress::coordinator: {
      std::vector<int> peers = {BusAddress::conductor};
      const bool one_host = address.launcher == BusAddress{}.launcher;
      for (int agent = BusAddress::first_agent; address.returns && one_host && agent < address.participants; ++agent) {
        peers.push_back(agent);
      }
      return peers;
    }
    default:
      return {BusAddress::conductor, BusAddress::coordinator};
  }
}

void find_each_other(dds::DomainParticipantQos& qos, const BusAddress& address) {
  auto& builtin = qos.wire_protocol().builtin;
  for (const int peer : peers_of(address)) {
    builtin.initialPeersList.push_back(locator_of(address, peer));
  }
  builtin.discovery_config.initial_announcements.count = first_announcements;
  builtin.discovery_config.initial_announcements.period = Duration_t(0, first_announcements_ms * ns_a_ms);
  // Later ones are for who was started again and has missed the first answer; hundreds leave each other time.
  const int later_ms = std::max(announcements_ms, address.participants * announcements_ms_a_head);
  builtin.discovery_config.leaseDuration_announcementperiod = Duration_t(later_ms / 1000, later_ms % 1000 * ns_a_ms);
  builtin.use_WriterLivelinessProtocol = false;  // who has died is known from the operating system
}

/// Fast DDS takes another port in silence, where nobody looks for this participant, if it cannot have its own.
void check_ports(const BusAddress& address) {
  const int first = discovery_port(address.domain, address.participant);
  for (const int port : {first, first + 1}) {
    if (!has_port(port)) {
      const std::string host = host_of(address, address.participant);
      const std::string complaint = port_complaint(host, port);
      throw run_failed("UDP port " + std::to_string(port) + " of " + host +
                       " cannot be had: " + (complaint.empty() ? "Fast DDS did not take it" : complaint));
    }
  }
}

template <class Qos>
void set_delivery(Qos& qos, bool latest, int depth) {
  qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.data_sharing().off();
  qos.endpoint().history_memory_policy = rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  qos.history().kind = dds::KEEP_LAST_HISTORY_QOS;
  qos.history().depth = latest ? 1 : depth;
  qos.resource_limits().allocated_samples = 1;
}

/// Between two times that a writer asks who has missed something.
template <class Message>
Duration_t heartbeat_of(const BusAddress& address) {
  if (address.apart || std::is_same_v<Message, Hello>) {  // a hello may come before its reader has found the writer
    return {0, 10 * ns_a_ms};
  }
  const bool may_be_lost = address.launcher != BusAddress{}.launcher || address.participants > most_in_buffers;
  return may_be_lost ? Duration_t{0, 200 * ns_a_ms} : Duration_t{1, 0};
}

}  // namespace

struct Participant::Entities {
  Roster roster;
  BusListener listener{roster};
  dds::DomainParticipant* participant = nullptr;
  dds::Publisher* publisher = nullptr;
  dds::Subscriber* subscriber = nullptr;
  std::vector<std::unique_ptr<dds::DataReaderListener>> inboxes;

  explicit Entities(const BusAddress& address) : roster(address) {}
  Entities(const Entities&) = delete;
  Entities& operator=(const Entities&) = delete;
  ~Entities() {
    if (participant != nullptr) {
      participant->delete_contained_entities();
      dds::DomainParticipantFactory::get_instance()->delete_participant(participant);
    }
  }

  template <class Message>
  dds::Topic* topic() const {
    if (auto* known = participant->lookup_topicdescription(Topic<Message>::name); known != nullptr) {
      return dynamic_cast<dds::Topic*>(known);
    }
    const dds::TypeSupport type(new MessageType<Message>(Topic<Message>::type));
    type.register_type(participant);
    return made(participant->create_topic(Topic<Message>::name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT),
                std::string("topic ") + Topic<Message>::name);
  }
};

Participant::Participant(const BusAddress& address, const std::string& name)
    : address_(address), entities_(std::make_unique<Entities>(address)) {
  ignore_surroundings();
  auto* factory = dds::DomainParticipantFactory::get_instance();
  if (!address.profiles.empty() && !succeeded(factory->load_XML_profiles_file(address.profiles))) {
    throw bad_input(address.profiles, 0, "Fast DDS finds no profiles there; give an XML file of its own format");
  }
  factory->load_profiles();
  dds::DomainParticipantQos qos = factory->get_default_participant_qos();
  qos.name(name.c_str());
  qos.wire_protocol().participant_id = address.participant;
  qos.allocation().send_buffers.preallocated_number = 1;  // of the five, of which a process seldom needs two
  qos.allocation().send_buffers.dynamic = true;
  use_own_host_only(qos, address);
  find_each_other(qos, address);
  if (!address.keys.empty()) {
    for (const auto& [property, value] : security_properties(address.keys)) {
      qos.properties().properties().emplace_back(property, value);
    }
  }
  const std::string protection = address.keys.empty() ? "" : ", protected by the keys in " + address.keys.string();
  entities_->participant = made(
      factory->create_participant(static_cast<std::uint32_t>(address.domain), qos, &entities_->listener,
                                  dds::StatusMask::publication_matched() << dds::StatusMask::subscription_matched()),
      "participant " + std::to_string(address.participant) + " in domain " + std::to_string(address.domain) +
          protection);
  check_ports(address);
  entities_->publisher = made(entities_->participant->create_publisher(dds::PUBLISHER_QOS_DEFAULT), "a publisher");
  entities_->subscriber = made(entities_->participant->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT), "a subscriber");
}

Participant::~Participant() = default;

void Participant::wait_for_match(std::chrono::milliseconds at_most) const {
  entities_->listener.wait(at_most);
}

std::vector<std::string> Participant::strangers() {
  return entities_->listener.strangers().named();
}

template <class Message>
Writer<Message>::Writer(Participant& participant) : run_(participant.address().run) {
  auto& entities = *participant.entities_;
  dds::DataWriterQos qos = entities.publisher->get_default_datawriter_qos();
  set_delivery(qos, Topic<Message>::latest, kept_samples);
  qos.publish_mode().kind = participant.address().participant >= BusAddress::first_agent
                                ? dds::SYNCHRONOUS_PUBLISH_MODE  // a sample or two to one or two readers
                                : dds::ASYNCHRONOUS_PUBLISH_MODE;
  // A sample that is lost takes a heartbeat at its end with it, and one that arrives need not be confirmed at once.
  qos.reliable_writer_qos().disable_heartbeat_piggyback = !participant.address().apart;
  set_heartbeat_period(qos, heartbeat_of<Message>(participant.address()));
  if (participant.address().apart) {
    set_nack_response_delay(qos, Duration_t(0, answer_ns_apart));
  } else if (!std::is_same_v<Message, Hello>) {
    // Without it each write wakes a thread that finds nothing to do; a hello that came too early is repeated at once.
    set_nack_suppression(qos, Duration_t(0, 200 * ns_a_ms));
  }
  writer_ = made(entities.publisher->create_datawriter(entities.topic<Message>(), qos),
                 std::string("a writer of ") + Topic<Message>::name);
}

template <class Message>
void Writer<Message>::write(const Message& message) {
  Sample<Message> sample{run_, message};
  if (!succeeded(writer_->write(&sample))) {
    throw run_failed(std::string("Fast DDS refused a sample of ") + Topic<Message>::name);
  }
}

template <class Message>
void Writer<Message>::wait_until_heard(std::chrono::milliseconds at_most) {
  writer_->wait_for_acknowledgments(Duration_t(static_cast<long double>(at_most.count()) / 1000.0L));
}

template <class Message>
int Writer<Message>::readers() const {
  dds::PublicationMatchedStatus status;
  writer_->get_publication_matched_status(status);
  return status.current_count;
}

template <class Message>
Reader<Message>::Reader(Participant& participant, const RegionRange& regions) {
  auto& entities = *participant.entities_;
  dds::DataReaderQos qos = entities.subscriber->get_default_datareader_qos();
  set_delivery(qos, Topic<Message>::latest, kept_samples);
  if (participant.address().apart) {
    set_heartbeat_response_delay(qos, Duration_t(0, answer_ns_apart));
  }
  // Also of a topic of one writer: a stranger's samples would push out the writer's own.
  qos.history().kind = dds::KEEP_ALL_HISTORY_QOS;
  qos.resource_limits().max_samples = Inbox<Message>::most_unread;
  qos.resource_limits().max_instances = 1;
  qos.resource_limits().max_samples_per_instance = Inbox<Message>::most_unread;
  auto inbox = std::make_unique<Inbox<Message>>(participant.address(), entities.roster, regions);
  inbox_ = inbox.get();
  entities.inboxes.push_back(std::move(inbox));
  reader_ = made(
      entities.subscriber->create_datareader(entities.topic<Message>(), qos, inbox_, dds::StatusMask::data_available()),
      std::string("a reader of ") + Topic<Message>::name);
}

template <class Message>
void Reader<Message>::wait(std::chrono::milliseconds at_most, std::size_t messages) const {
  inbox_->wait(at_most, messages);
}

template <class Message>
std::vector<Heard<Message>> Reader<Message>::take() {
  return inbox_->take();
}

template <class Message>
std::map<std::string, int> Reader<Message>::refused() {
  return inbox_->refused();
}

template <class Message>
int Reader<Message>::writers() const {
  dds::SubscriptionMatchedStatus status;
  reader_->get_subscription_matched_status(status);
  return status.current_count;
}

template class Writer<Hello>;
template class Writer<Faults>;
template class Writer<Tick>;
template class Writer<std::vector<Report>>;
template class Writer<Plan>;
template class Writer<std::vector<Departures>>;
template class Reader<Hello>;
template class Reader<Faults>;
template class Reader<Tick>;
template class Reader<std::vector<Report>>;
template class Reader<Plan>;
template class Reader<std::vector<Departures>>;

}  // namespace evbal
