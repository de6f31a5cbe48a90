#include "tools/report/draw_figures.hpp"

#include "common/error.hpp"
#include "common/files.hpp"
#include "common/installation.hpp"
#include "common/run_program.hpp"
#include "common/scratch_folder.hpp"
#include "tools/report/assets.hpp"
#include "tools/report/study_json.hpp"

#include <nlohmann/json.hpp>

#include <chrono>

namespace evbal {
namespace {

/// Where Debian's packages for Node.js lie, which a Node.js from elsewhere does not look through by itself.
constexpr const char* modules_folder = "NODE_PATH=/usr/share/nodejs";

}  // namespace

std::vector<std::string> drawn_figures(const std::vector<StudyFigure>& figures) {
  const std::filesystem::path node = find_program("nodejs");
  if (node.empty()) {
    throw run_failed("the figures are drawn by the packages nodejs and node-jsdom; there is no program `nodejs`");
  }
  const ScratchFolder folder;
  const auto program = folder.path() / "draw_files.js";
  const auto scripts = folder.path() / "scripts.js";
  const auto data = folder.path() / "figures.json";
  write_file(program, draw_files_js);
  write_file(scripts, std::string(d3_js) + "\n" + figures_js);
  write_file(data, figures_json(figures).dump());
  const ProgramResult drawn =
      run_program({"env", modules_folder, node, program, scripts, data}, std::chrono::minutes(2));
  if (drawn.status != 0) {
    const bool missing = drawn.errors.find("Cannot find module 'jsdom'") != std::string::npos;
    throw run_failed("the figures are drawn by the packages nodejs and node-jsdom; " +
                     (missing ? "there is no jsdom" : "drawing failed: " + drawn.errors));
  }
  return nlohmann::json::parse(drawn.output).get<std::vector<std::string>>();
}

}  // namespace evbal
