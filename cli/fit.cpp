// clog fit: a power law for any column of numbers.
#include <filesystem>
#include <memory>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "coupling/base/number_column.hpp"
#include "postprocess/output/fit_json.hpp"

namespace clogflow::cli {
namespace {

constexpr std::size_t default_replicates = 1000;

struct FitOptions {
  std::filesystem::path file;
  double xmin = 0;
  std::size_t replicates = default_replicates;
  std::uint64_t seed = 1;
  bool discrete = false, continuous = false;
};

nlohmann::json fit_column(const FitOptions& options, const postprocess::FitRequest& request) {
  using postprocess::Values;
  const auto values = postprocess::read_number_column(options.file);
  const Values found = postprocess::recognised(values);
  const Values kind = options.discrete ? Values::whole : options.continuous ? Values::continuous : found;
  const postprocess::SortedSample sample(values, kind);
  nlohmann::json fit = as_json(fit_tail(sample, request));
  fit["discrete_from"] = options.discrete || options.continuous ? "given" : "values";
  if (found == Values::whole && sample.kind() == Values::continuous)
    fit["notes"] = {"whole numbers fitted with a continuous law: alpha is biased, the more the smaller xmin"};
  return fit;
}

}  // namespace

void add_fit(CLI::App& app) {
  auto* verb = app.add_subcommand("fit", "Clauset-Shalizi-Newman power-law fit of a column of numbers");
  auto options = std::make_shared<FitOptions>();
  verb->add_option("file", options->file, "plain text, one number a line, # starts a comment")->required();
  auto* xmin = verb->add_option("--xmin", options->xmin, "fix the lower end instead of scanning for it");
  auto* p_value =
      verb->add_option("--p-value", options->replicates, "goodness of fit from N bootstrap replicates (default 1000)")
          ->expected(0, 1)
          ->check(CLI::PositiveNumber);
  verb->add_option("--seed", options->seed, "of the bootstrap")->capture_default_str();
  auto* discrete = verb->add_flag("--discrete", options->discrete, "the law of whole numbers (default: if they are)");
  verb->add_flag("--continuous", options->continuous, "the law of any numbers")->excludes(discrete);
  verb->callback([options, xmin, p_value] {
    postprocess::FitRequest request{.xmin = {}, .seed = options->seed};
    if (xmin->count() > 0) request.xmin = options->xmin;
    if (p_value->count() > 0) {
      request.p_value_replicates = p_value->as<std::string>().empty() ? default_replicates : options->replicates;
    }
    print_json(fit_column(*options, request));
  });
}

}  // namespace clogflow::cli
