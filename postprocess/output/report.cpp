// Two of the scripts that draw.
#include "postprocess/output/report.hpp"

#include "coupling/base/require.hpp"
#include "postprocess/output/figure_scripts.hpp"

namespace clogflow::postprocess {

namespace fs = std::filesystem;

std::vector<fs::path> make_report(const fs::path& statistics, const fs::path& out, const ReportLook& look) {
  const auto within = [](double value, double low, double high) {
    return value == 0 || (value >= low && value <= high);
  };
  require(within(look.figure_width, narrowest_figure, widest_figure), "--figure-width {} mm: from {} to {} mm",
          1e3 * look.figure_width, 1e3 * narrowest_figure, 1e3 * widest_figure);
  require(within(look.font_size, smallest_font, largest_font), "--font-size {}: from {} to {} points", look.font_size,
          smallest_font, largest_font);
  std::vector<std::string> more;
  const auto add = [&](const char* option, const std::string& value) { more.insert(more.end(), {option, value}); };
  if (look.figure_width > 0) add("--figure-width", fmt::format("{}", look.figure_width));
  if (look.font_size > 0) add("--font-size", fmt::format("{}", look.font_size));
  if (!look.flow.empty()) add("--flow", fs::absolute(look.flow).string());
  if (!look.command.empty()) add("--command", look.command);
  return run_figure_script("make_report.py", statistics, out, "", more);
}

std::vector<fs::path> make_trade_figure(const fs::path& results, const fs::path& out) {
  return run_figure_script("fig_trade.py", results, out);
}

}  // namespace clogflow::postprocess
