#include "tools/fit/fit_command.hpp"

#include "agents/region/world.hpp"
#include "coordinator/planning/settings.hpp"
#include "tools/fit/fit_city.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace evbal {
namespace {

/// Error left of the seasonal mean's or the last value's, in per cent, over all leads.
void print_skill(const char* what, const Skill& skill) {
  if (skill.seasonal_mean.sum() <= 0.0) {
    return;
  }
  std::printf("%-34s", what);
  for (Eigen::Index lead = 0; lead < skill.forecast.cols(); ++lead) {
    std::printf("   step %d: %5.1f %% of seasonal mean's, %5.1f %% of last value's", static_cast<int>(lead) + 1,
                100.0 * skill.forecast.col(lead).sum() / skill.seasonal_mean.col(lead).sum(),
                100.0 * skill.forecast.col(lead).sum() / skill.last_value.col(lead).sum());
  }
  std::printf("\n");
}

void print_thresholds(const std::vector<ThresholdRow>& rows) {
  std::printf("\nthresholds at alpha_h = 0.25, 1000 replicates of N_B residuals\n");
  std::printf("%6s  %28s  %28s\n", "", "demand", "completions");
  std::printf("%6s", "N_B");
  for (int series = 0; series < 2; ++series) {
    std::printf("  %8s  %8s  %8s", "g1", "sqrt g1", "g2");
  }
  std::printf("\n");
  for (const ThresholdRow& row : rows) {
    std::printf("%6d", row.resample);
    for (const Thresholds& g : {row.demand, row.completions}) {
      std::printf("  %8.4f  %8.4f  %8.4f", g.g1, std::sqrt(g.g1), g.g2);
    }
    std::printf("\n");
  }
}

void fit(const std::string& name, const std::string& out) {
  const City city = find_city(name);
  const CityFit fitted = fit_city(city, [](const std::string& line) { std::cout << line << std::endl; });
  const std::filesystem::path file = out.empty() ? model_file({}, city) : std::filesystem::path(out);
  write_model(fitted.model, file);
  std::printf("greedy on the training days: %d served, %d lost (%.1f %%)\n\nsquared forecast error\n", fitted.served,
              fitted.lost, 100.0 * fitted.lost / std::max(1, fitted.served + fitted.lost));
  print_skill("demand, training day left out", fitted.demand);
  print_skill("demand, test days", fitted.demand_test);
  print_skill("completions, training day left out", fitted.completions);
  print_thresholds(fitted.thresholds);
  std::printf("\nwrote %s\n", file.c_str());
}

}  // namespace

void add_fit_command(CLI::App& app) {
  struct Arguments {
    std::string city;
    std::string out;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("fit", "Estimate forecasts, uncertainty sets and transitions of a city");
  command->add_option("city", arguments->city, "Shipped city or folder of a pack")->required();
  command->add_option("--out", arguments->out, "File to write; without it, model.json beside the pack");
  command->callback([arguments] { fit(arguments->city, arguments->out); });
}

}  // namespace evbal
