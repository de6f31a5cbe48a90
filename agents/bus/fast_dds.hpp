#pragma once

#include "agents/bus/cdr.hpp"
#include "agents/bus/roster.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#if __has_include(<fastdds/utils/IPLocator.hpp>)
#define EVBAL_FAST_DDS_3
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.hpp>
#include <fastdds/utils/IPLocator.hpp>
#else
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>
#endif

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>

/// Fast DDS as the bus uses it. All that its versions 2 (Debian 12) and 3 (Debian 13) name differently stands here.
namespace evbal::fast_dds {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;

#ifdef EVBAL_FAST_DDS_3

namespace rtps = eprosima::fastdds::rtps;
using dds::Duration_t;
using ReturnCode = dds::ReturnCode_t;
constexpr ReturnCode return_ok = dds::RETCODE_OK;

inline void set_heartbeat_period(dds::DataWriterQos& qos, const Duration_t& period) {
  qos.reliable_writer_qos().times.heartbeat_period = period;
}
inline void set_nack_response_delay(dds::DataWriterQos& qos, const Duration_t& delay) {
  qos.reliable_writer_qos().times.nack_response_delay = delay;
}
inline void set_nack_suppression(dds::DataWriterQos& qos, const Duration_t& duration) {
  qos.reliable_writer_qos().times.nack_supression_duration = duration;
}
inline void set_heartbeat_response_delay(dds::DataReaderQos& qos, const Duration_t& delay) {
  qos.reliable_reader_qos().times.heartbeat_response_delay = delay;
}

#else

namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastrtps::Duration_t;
using ReturnCode = eprosima::fastrtps::types::ReturnCode_t;
constexpr auto return_ok = ReturnCode::RETCODE_OK;

inline void set_heartbeat_period(dds::DataWriterQos& qos, const Duration_t& period) {
  qos.reliable_writer_qos().times.heartbeatPeriod = period;
}
inline void set_nack_response_delay(dds::DataWriterQos& qos, const Duration_t& delay) {
  qos.reliable_writer_qos().times.nackResponseDelay = delay;
}
inline void set_nack_suppression(dds::DataWriterQos& qos, const Duration_t& duration) {
  qos.reliable_writer_qos().times.nackSupressionDuration = duration;
}
inline void set_heartbeat_response_delay(dds::DataReaderQos& qos, const Duration_t& delay) {
  qos.reliable_reader_qos().times.heartbeatResponseDelay = delay;
}

#endif

using rtps::IPLocator;

inline bool succeeded(const ReturnCode& code) {
  return code == return_ok;
}
/// What version 2 returns where version 3 has a code.
inline bool succeeded(bool done) {
  return done;
}

inline GuidPrefix prefix_of(const rtps::GUID_t& guid) {
  GuidPrefix prefix{};
  std::copy_n(guid.guidPrefix.value, prefix.size(), prefix.begin());
  return prefix;
}

/// Is told who comes to the bus and leaves it, and who proves to belong there or fails to.
class DiscoveryListener : public dds::DomainParticipantListener {
 public:
  virtual void on_seen(const GuidPrefix& who, const std::string& name) = 0;
  virtual void on_left(const GuidPrefix& who) = 0;
  virtual void on_proof(const GuidPrefix& who, bool proved) = 0;

#ifdef EVBAL_FAST_DDS_3

  void on_participant_discovery(dds::DomainParticipant* /*participant*/, rtps::ParticipantDiscoveryStatus status,
                                const dds::ParticipantBuiltinTopicData& info, bool& /*should_be_ignored*/) override {
    tell(status, info.guid, info.participant_name.to_string());
  }
  void onParticipantAuthentication(dds::DomainParticipant* /*participant*/,
                                   rtps::ParticipantAuthenticationInfo&& info) override {
    on_proof(prefix_of(info.guid), info.status == info.AUTHORIZED_PARTICIPANT);
  }

 private:
  using Status = rtps::ParticipantDiscoveryStatus;

#else

  void on_participant_discovery(dds::DomainParticipant* /*participant*/,
                                rtps::ParticipantDiscoveryInfo&& info) override {
    tell(info.status, info.info.m_guid, info.info.m_participantName.to_string());
  }
  void onParticipantAuthentication(dds::DomainParticipant* /*participant*/,
                                   rtps::ParticipantAuthenticationInfo&& info) override {
    on_proof(prefix_of(info.guid), info.status == info.AUTHORIZED_PARTICIPANT);
  }

 private:
  using Status = rtps::ParticipantDiscoveryInfo::DISCOVERY_STATUS;

#endif

  void tell(Status status, const rtps::GUID_t& guid, const std::string& name) {
    if (status == Status::DISCOVERED_PARTICIPANT) {
      on_seen(prefix_of(guid), name);
    } else if (status != Status::CHANGED_QOS_PARTICIPANT) {
      on_left(prefix_of(guid));
    }
  }
};

/// How a sample becomes bytes, and bytes a sample.
template <class Message>
struct SampleBytes {
  static bool write(const void* data, rtps::SerializedPayload_t& payload) {
    const auto& sample = *static_cast<const Sample<Message>*>(data);
    const std::size_t size = cdr_size(sample);
    if (size > payload.max_size) {
      return false;
    }
    write_cdr(sample, reinterpret_cast<char*>(payload.data));
    payload.encapsulation = CDR_LE;
    payload.length = static_cast<std::uint32_t>(size);
    return true;
  }

  static bool read(const rtps::SerializedPayload_t& payload, void* data) {
    auto& sample = *static_cast<Sample<Message>*>(data);
    sample = read_cdr<Message>({reinterpret_cast<const char*>(payload.data), payload.length}, sample.regions);
    return true;
  }

  static std::uint32_t size(const void* data) {
    return static_cast<std::uint32_t>(cdr_size(*static_cast<const Sample<Message>*>(data)));
  }
};

/// Samples of a Message for Fast DDS. Bytes that are no message give a sample that says so: a reader of garbage must
/// neither end nor ask for memory that no message needs.
template <class Message, class Bytes = SampleBytes<Message>>
class MessageType : public dds::TopicDataType {
 public:
  /// Bytes with which Fast DDS begins; it takes more for what is longer.
  static constexpr std::uint32_t first_reserved = 1024;

#ifdef EVBAL_FAST_DDS_3

  explicit MessageType(const std::string& name) {
    set_name(name);
    max_serialized_type_size = first_reserved;
    is_compute_key_provided = false;
  }

  bool serialize(const void* data, rtps::SerializedPayload_t& payload, dds::DataRepresentationId_t /*xcdr*/) override {
    return Bytes::write(data, payload);
  }
  bool deserialize(rtps::SerializedPayload_t& payload, void* data) override {
    return Bytes::read(payload, data);
  }
  std::uint32_t calculate_serialized_size(const void* data, dds::DataRepresentationId_t /*xcdr*/) override {
    return Bytes::size(data);
  }
  void* create_data() override {
    return new Sample<Message>;
  }
  void delete_data(void* data) override {
    delete static_cast<Sample<Message>*>(data);
  }
  bool compute_key(rtps::SerializedPayload_t& /*payload*/, rtps::InstanceHandle_t& /*key*/, bool /*md5*/) override {
    return false;
  }
  bool compute_key(const void* /*data*/, rtps::InstanceHandle_t& /*key*/, bool /*md5*/) override {
    return false;
  }

#else

  explicit MessageType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = first_reserved;
    m_isGetKeyDefined = false;
    auto_fill_type_object(false);  // else half a megabyte of descriptions of types, which nobody of a run asks for
    auto_fill_type_information(false);
  }

  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    return Bytes::write(data, *payload);
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    return Bytes::read(*payload, data);
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return Bytes::size(data); };
  }
  void* createData() override {
    return new Sample<Message>;
  }
  void deleteData(void* data) override {
    delete static_cast<Sample<Message>*>(data);
  }
  bool getKey(void* /*data*/, rtps::InstanceHandle_t* /*key*/, bool /*md5*/) override {
    return false;
  }

#endif
};

}  // namespace evbal::fast_dds
