#pragma once

#include "agents/bus/cdr.hpp"

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <cstdint>
#include <functional>
#include <string>

/// Fast DDS 2 as the bus uses it. All that another version names otherwise stands in this file.
namespace evbal::fast_dds {

namespace dds = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;
using eprosima::fastdds::rtps::UDPv4TransportDescriptor;
using eprosima::fastrtps::Duration_t;
using rtps::IPLocator;

inline bool succeeded(const eprosima::fastrtps::types::ReturnCode_t& code) {
  return code == eprosima::fastrtps::types::ReturnCode_t::RETCODE_OK;
}

/// Samples of a Message for Fast DDS. Bytes that are no message give a sample that says so: a reader of garbage must
/// neither end nor ask for memory that no message needs.
template <class Message>
class MessageType : public dds::TopicDataType {
 public:
  /// Bytes with which Fast DDS begins; it takes more for what is longer.
  static constexpr std::uint32_t first_reserved = 1024;

  explicit MessageType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = first_reserved;
    m_isGetKeyDefined = false;
  }

  bool serialize(void* data, rtps::SerializedPayload_t* payload) override {
    const auto& sample = *static_cast<Sample<Message>*>(data);
    const std::size_t size = cdr_size(sample);
    if (size > payload->max_size) {
      return false;
    }
    write_cdr(sample, reinterpret_cast<char*>(payload->data));
    payload->encapsulation = CDR_LE;
    payload->length = static_cast<std::uint32_t>(size);
    return true;
  }

  bool deserialize(rtps::SerializedPayload_t* payload, void* data) override {
    *static_cast<Sample<Message>*>(data) =
        read_cdr<Message>({reinterpret_cast<const char*>(payload->data), payload->length});
    return true;
  }

  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] { return static_cast<std::uint32_t>(cdr_size(*static_cast<Sample<Message>*>(data))); };
  }

  void* createData() override { return new Sample<Message>; }
  void deleteData(void* data) override { delete static_cast<Sample<Message>*>(data); }
  bool getKey(void* /*data*/, rtps::InstanceHandle_t* /*key*/, bool /*md5*/) override { return false; }
};

}  // namespace evbal::fast_dds
