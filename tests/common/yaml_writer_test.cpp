#include "common/yaml_writer.hpp"

#include "common/yaml.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace evbal {
namespace {

TEST(YamlWriter, LaysOutMapsAndLists) {
  YamlWriter yaml;
  yaml.key("name").text("a: \"b\"").key("count").number(3).key("share").number(1e-7).key("wait").minutes(2.5);
  yaml.key("clock").begin_map(YamlWriter::Layout::one_line).key("on").boolean(true).key("list").begin_list();
  yaml.number(1).number(2).end_list().end_map();
  yaml.key("items").begin_list().word("one").begin_map().key("two").word("three").end_map().end_list();
  yaml.key("none").begin_list().end_list();
  EXPECT_EQ(yaml.finish(),
            "name: \"a: \\\"b\\\"\"\n"
            "count: 3\n"
            "share: 0.0000001\n"
            "wait: 2.5min\n"
            "clock: {on: true, list: [1, 2]}\n"
            "items:\n"
            "  - one\n"
            "  - two: three\n"
            "none:\n"
            "  []\n");
}

RC_GTEST_PROP(YamlWriter, IsReadBackTheSame, ()) {
  const auto any = rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab #:|-~{}[]\"'\\,&*!%@`?>0")));
  const auto key = *rc::gen::nonEmpty(any);
  const auto text = *any;
  YamlWriter yaml;
  yaml.key("in").begin_map().key(key).text(text).end_map();
  YamlMap map(YamlValue::parse(yaml.finish(), "a.yaml"));
  YamlMap in(map.require("in"));
  RC_ASSERT(in.require(key).text() == text);
}

}  // namespace
}  // namespace evbal
