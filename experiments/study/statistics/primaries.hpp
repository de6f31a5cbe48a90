#pragma once

#include "experiments/study/design/page.hpp"
#include "experiments/study/statistics/comparison.hpp"

#include <string>
#include <vector>

/// The primary endpoints of a page: the family for which p values are adjusted, wherever one of them is shown.
namespace evbal {

/// Whether a row of an answer to `question` is that of the endpoint.
bool is_row_of(const PrimaryEndpoint& primary, const Question& question, const Compared& row);

/// A primary endpoint and what came of it.
struct PrimaryAnswer {
  std::string section;  ///< title, or the question of the verdict
  Question question;    ///< that it answers
  Compared row;         ///< the answer; without days if there is none
  double p_holm = 1.0;  ///< its p value as Holm adjusts it for all of the page, those without an answer too

  /// What is shown, with p_holm below 0.05: -1 that the variant is lower, 1 that it is higher; 0 if nothing is.
  int shown() const;

  /// The endpoint that it answers.
  PrimaryEndpoint endpoint() const;

  /// Whether a row of an answer to `asked` is this one.
  bool is(const Question& asked, const Compared& other) const;
};

/// The page's metric `objective` added to the days.
std::vector<FinishedDay> with_objective(const Page& page, std::vector<FinishedDay> days);

/// What came of each, in the order of the page: those of its verdict, then those of its sections that are no part of
/// it. `days` have the page's objective.
std::vector<PrimaryAnswer> primary_answers(const Page& page, const std::vector<FinishedDay>& days);

/// A p with four digits; of one that these do not show, that it is less.
std::string p_text(double p);

/// The page of a sweep whose file is `text` and whose days are `days`, played or not; one without sections if it has
/// none.
Page page_of(const std::string& text, const std::vector<FinishedDay>& days);

}  // namespace evbal
