// Seeds as text: ranges and single numbers, in the order given.
#include <algorithm>
#include <charconv>
#include <set>

#include "coupling/base/require.hpp"
#include "coupling/base/shown_text.hpp"
#include "coupling/scene/scene.hpp"

namespace clogflow {
namespace {

constexpr std::uint64_t largest_seed = 999'999'999;
constexpr std::size_t most_seeds = 1'000'000;

std::uint64_t read_seed(std::string_view text, const std::string& whole) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  std::uint64_t seed = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), seed);
  require(status == std::errc{} && end == text.data() + text.size() && seed <= largest_seed,
          "\"{}\" (must be whole numbers up to {}, e.g. \"1-40\" or \"1-4,9\")", shown_text(whole), largest_seed);
  return seed;
}

}  // namespace

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  std::vector<std::uint64_t> seeds;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    const std::string_view part = std::string_view(text).substr(at, end - at);
    const std::size_t dash = part.find('-');
    const std::uint64_t first = read_seed(part.substr(0, dash), text);
    const std::uint64_t last = dash == std::string_view::npos ? first : read_seed(part.substr(dash + 1), text);
    require(first <= last, "\"{}\" (the range {} runs backwards)", shown_text(text), part);
    require(seeds.size() + (last - first) < most_seeds, "\"{}\" (more than {} seeds)", shown_text(text), most_seeds);
    for (std::uint64_t seed = first; seed <= last; ++seed) seeds.push_back(seed);
    at = end + 1;
  }
  // One seed is one file: named twice it would be written twice.
  std::set<std::uint64_t> seen;
  for (const std::uint64_t seed : seeds)
    require(seen.insert(seed).second, "\"{}\" (seed {} is named twice)", shown_text(text), seed);
  return seeds;
}

std::string format_seeds(const std::vector<std::uint64_t>& seeds) {
  std::string text;
  for (std::size_t first = 0; first < seeds.size();) {
    std::size_t last = first;
    while (last + 1 < seeds.size() && seeds[last + 1] == seeds[last] + 1) ++last;
    text += fmt::format("{}{}", first == 0 ? "" : ",", seeds[first]);
    if (last > first) text += fmt::format("-{}", seeds[last]);
    first = last + 1;
  }
  return text;
}

}  // namespace clogflow
