#include "common/suggestion.hpp"

#include <algorithm>
#include <numeric>

namespace evbal {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (const auto& word : words) {
    text += (text.empty() ? "`" : ", `") + word + "`";
  }
  return text;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& words) {
  const auto best = std::min_element(words.begin(), words.end(), [&](const auto& a, const auto& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  if (best == words.end() || edit_distance(word, *best) > std::max<std::size_t>(2, best->size() / 3)) {
    return "";
  }
  return " (did you mean `" + *best + "`?)";
}

std::string validate_word(const std::string& word, const std::vector<std::string>& words) {
  return std::find(words.begin(), words.end(), word) != words.end()
             ? ""
             : "`" + word + "` is not known" + did_you_mean(word, words) + "; choose one of " + listed(words);
}

}  // namespace evbal
