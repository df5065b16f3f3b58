// clog stats: the numbers of an ensemble.
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "cli/verbs.hpp"
#include "coupling/base/require.hpp"
#include "coupling/base/units.hpp"
#include "postprocess/output/statistics_files.hpp"

namespace clogflow::cli {
namespace {

double threshold_seconds(const std::string& text) {
  const Quantity quantity = parse_quantity(text);
  require(quantity.dimension == dimension::time && quantity.si > 0,
          "--threshold {} (must be a positive time such as '3.3 ms')", text);
  return quantity.si;
}

/// The value, or the bound on it, or what it lacks.
std::string known(const nlohmann::json& q) {
  const auto number = [&](const char* side) { return fmt::format("{:.4g}", q.at(side).get<double>()); };
  const std::string note = q.value("note", "");
  if (q.at("value").is_null()) {
    if (!q.at("high").is_null()) return fmt::format("below {} ({})", number("high"), note);
    if (!q.at("low").is_null()) return fmt::format("above {} ({})", number("low"), note);
    return fmt::format("unknown ({})", note);
  }
  if (q.at("low").is_null()) return number("value");
  return fmt::format("{} [{}, {}]", number("value"), number("low"), number("high"));
}

std::string with_interval(const nlohmann::json& group, const char* key) {
  const auto& q = group.at("quantities").at(key);
  const bool drifts = q.contains("ages") && q.at("ages") == true;
  return known(q) + (drifts ? " (drifts: first and second half differ)" : "");
}

/// What is known to be wrong with the laws behind the numbers.
void print_verdicts(const nlohmann::json& group) {
  const auto& alpha = group.at("quantities").at("alpha_fixed");
  if (alpha.value("ruled_out", false)) fmt::print("  alpha: {}\n", alpha.at("verdict").get<std::string>());
  const auto& bursts = group.at("bursts");
  if (bursts.contains("geometric") && bursts.at("geometric").at("ruled_out") == true)
    fmt::print("  s: geometric law {}\n", bursts.at("geometric").at("verdict").get<std::string>());
}

void print_summary(const nlohmann::json& statistics) {
  for (const auto& group : statistics.at("groups")) {
    const bool by_release = group.at("protocol") == "release";
    fmt::print("{}: {} seeds, {} bursts, <s> = {}, {} = {}, {} passages/s\n", group.at("label").get<std::string>(),
               group.at("runs").size(), group.at("bursts").at("counted").get<std::size_t>(),
               with_interval(group, "mean_burst"), by_release ? "releases without a passage" : "alpha(T_min)",
               with_interval(group, by_release ? "share_failed" : "alpha_fixed"), with_interval(group, "flow_rate"));
    print_verdicts(group);
  }
}

/// The laws of a sweep, or why there is none; nothing for a single ensemble.
void print_trend(const nlohmann::json& statistics) {
  const auto& trend = statistics.at("trend");
  for (const auto& name : trend.at("without_runs")) fmt::print("{}: no runs yet\n", name.get<std::string>());
  if (statistics.at("groups").size() < 2) return;
  for (const auto& series : trend.at("series")) {
    for (const auto& [key, symbol] : {std::pair("mean_burst", "<s>"), {"alpha", "alpha"}}) {
      const auto& fit = series.at(key);
      const std::string label = series.at("label");
      fmt::print("{}{}", label, label.empty() ? "" : ": ");
      if (fit.contains("refused")) {
        fmt::print("no law for {}: {}\n", symbol, fit.at("refused").get<std::string>());
        continue;
      }
      const auto& b = fit.at("b");
      fmt::print("{} = A exp(b {}), b = {:.4g} [{:.4g}, {:.4g}] from {} points, p = {:.2g}\n", symbol,
                 fit.at("x").get<std::string>(), b.at("value").get<double>(), b.at("low").get<double>(),
                 b.at("high").get<double>(), fit.at("points").get<std::size_t>(), fit.at("p_value").get<double>());
    }
  }
}

}  // namespace

void add_stats(CLI::App& app) {
  auto* verb = app.add_subcommand("stats", "bursts, arrests and fits from run files");
  auto job = std::make_shared<postprocess::StatisticsJob>();
  auto threshold = std::make_shared<std::string>();
  verb->add_option("dirs", job->folders, "folders with run_*.h5, or a sweep's folder of such folders")->required();
  verb->add_option("--out", job->out, "folder for stats.json and the tables")->required();
  verb->add_option("--threshold", *threshold, "shortest lapse that is a clog, such as '3.3 ms' (default tau/2)");
  verb->add_option("--p-value", job->request.p_value_replicates, "bootstrap replicates of the goodness of fit, 0: none")
      ->capture_default_str();
  verb->add_option("--seed", job->request.resampling.seed, "of all bootstraps")->capture_default_str();
  verb->callback([job, threshold] {
    if (!threshold->empty()) job->threshold = threshold_seconds(*threshold);
    const auto statistics = postprocess::write_statistics(*job);
    print_summary(statistics);
    print_trend(statistics);
  });
}

}  // namespace clogflow::cli
