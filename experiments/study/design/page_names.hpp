#pragma once

#include "experiments/study/design/page.hpp"

#include <string>
#include <vector>

/// How the parts of a page are read.
namespace evbal {

/// What a page may speak of.
struct KnownNames : PageNames {
  std::vector<std::string> metrics;  ///< by name
};

/// The text, which is one of `words`. Throws Error{bad_input} if it is no `what`, with the one that may be meant.
std::string read_known(const YamlValue& word, const char* what, const std::vector<std::string>& words);

/// The items of a list, each one of `words`. Throws as read_known, or if one is given twice.
std::vector<std::string> read_known_items(const YamlValue& list, const char* what,
                                          const std::vector<std::string>& words);

/// A comparison of whole fronts: variants, against, metrics, at, primary.
CompareSection read_fronts(YamlMap& map, const KnownNames& names);

/// The page's `verdict`.
std::vector<VerdictQuestion> read_verdict(const YamlValue& value, const KnownNames& names);

/// The page's `figures`.
std::vector<PageFigure> read_figures(const YamlValue& value, const KnownNames& names);

/// The page's `names`.
std::map<std::string, std::string> read_names(const YamlValue& value, const KnownNames& names);

}  // namespace evbal
