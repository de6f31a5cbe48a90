#include "tools/evbal/study_page.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "experiments/study/store/sweep_file.hpp"
#include "experiments/study/store/sweep_folder.hpp"
#include "tools/evbal/bounded_days.hpp"
#include "tools/report/draw_figures.hpp"

#include <cstdio>

namespace evbal {

namespace fs = std::filesystem;

StudyPage read_study_page(const fs::path& folder) {
  const fs::path file = folder / sweep_file_name;
  const auto days = read_finished(file);
  StudyPage study;
  study.origin = read_origin(file);
  study.page = page_of(study.origin.text, days);
  study.days = {with_objective(study.page, days), kept_bounds(file, days)};
  study.primaries = primary_answers(study.page, study.days.days);
  study.figures = study_figures(study.page, study.days, study.primaries);
  return study;
}

PageText study_text(const StudyPage& study) {
  return page_text(study.page, study.days, study.primaries, study.origin.command);
}

void write_study_page(const fs::path& folder, const StudyPage& study) {
  write_file(folder / "page.md", page_markdown(study.page.title, study_text(study), study.figures));
  fs::remove_all(folder / "figures");
  if (study.page.figures.empty()) {
    return;
  }
  try {
    write_study_figures(folder, study);
  } catch (const Error& error) {
    std::fprintf(stderr, "evbal: page.md is written without its figures: %s; `evbal report %s --figures` draws them\n",
                 error.what(), folder.c_str());
  }
}

fs::path write_study_figures(const fs::path& folder, const StudyPage& study) {
  if (study.figures.empty()) {
    throw bad_input(folder.string() + ": the sweep's page names no `figures`");
  }
  const auto drawn = drawn_figures(study.figures);
  fs::create_directories(folder / "figures");
  for (std::size_t i = 0; i < study.figures.size(); ++i) {
    write_file(folder / "figures" / (study.figures[i].name + ".svg"), drawn[i]);
  }
  return folder / "figures";
}

}  // namespace evbal
