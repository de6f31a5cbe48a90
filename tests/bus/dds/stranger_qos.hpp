#pragma once

#include "agents/bus/fast_dds.hpp"
#include "agents/bus/ports.hpp"

#include <cstdint>
#include <memory>

namespace evbal::test {

/// What a participant that is none of the run's asks for, to meet all `participants` of the run in `domain`.
inline fast_dds::dds::DomainParticipantQos stranger_qos(int domain, int participants) {
  fast_dds::dds::DomainParticipantQos qos;
  qos.wire_protocol().participant_id = participants + 20;
  qos.transport().use_builtin_transports = false;
  const auto udp = std::make_shared<fast_dds::UDPv4TransportDescriptor>();
  udp->interfaceWhiteList = {"127.0.0.1"};
  qos.transport().user_transports.push_back(udp);
  for (int peer = 0; peer < participants; ++peer) {
    fast_dds::rtps::Locator_t locator;
    locator.kind = LOCATOR_KIND_UDPv4;
    fast_dds::IPLocator::setIPv4(locator, 127, 0, 0, 1);
    locator.port = static_cast<std::uint32_t>(discovery_port(domain, peer));
    qos.wire_protocol().builtin.initialPeersList.push_back(locator);
  }
  return qos;
}

/// What its writers ask for: to be heard by readers of the run.
inline fast_dds::dds::DataWriterQos stranger_writer_qos() {
  fast_dds::dds::DataWriterQos qos;
  qos.reliability().kind = fast_dds::dds::RELIABLE_RELIABILITY_QOS;
  qos.durability().kind = fast_dds::dds::TRANSIENT_LOCAL_DURABILITY_QOS;
  qos.data_sharing().off();
  qos.endpoint().history_memory_policy = fast_dds::rtps::DYNAMIC_REUSABLE_MEMORY_MODE;
  return qos;
}

}  // namespace evbal::test
