// Two of the scripts that draw.
#include "postprocess/output/report.hpp"

#include "postprocess/output/figure_scripts.hpp"

namespace clogflow::postprocess {

namespace fs = std::filesystem;

std::vector<fs::path> make_report(const fs::path& statistics, const fs::path& out) {
  return run_figure_script("make_report.py", statistics, out);
}

std::vector<fs::path> make_trade_figure(const fs::path& results, const fs::path& out) {
  return run_figure_script("fig_trade.py", results, out);
}

}  // namespace clogflow::postprocess
