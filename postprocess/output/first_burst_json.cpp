#include "postprocess/output/first_burst_json.hpp"

#include "postprocess/output/fit_json.hpp"

namespace clogflow::postprocess {
namespace {

using nlohmann::json;

json as_json(const MeanCount& mean) {
  json entry = as_json(mean.mean);
  entry["restricted_to"] = mean.is_restricted ? json(mean.up_to) : json();
  return entry;
}

json as_json(const HazardBin& bin) {
  json entry = as_json(bin.hazard);
  entry.update({{"from", bin.from}, {"to", bin.to}, {"clogs", bin.events}, {"trials", bin.trials}});
  return entry;
}

json as_json(const Fifth& fifth) {
  json entry = as_json(fifth.mean);
  entry["bursts"] = fifth.bursts;
  return entry;
}

}  // namespace

json as_json(const FirstBurstStatistics& statistics) {
  json bins = json::array();
  for (const HazardBin& bin : statistics.hazard_bins) bins.push_back(as_json(bin));
  json geometric{{"ruled_out", statistics.verdict.ruled_out}, {"verdict", statistics.verdict.words}};
  if (statistics.geometric)
    geometric.update({{"ks", statistics.geometric->ks}, {"p_value", statistics.geometric->p_value}});
  if (const auto& tail = statistics.tail)
    geometric["tail"] = {{"from", tail->from},
                         {"clogs", tail->events},
                         {"p_value", tail->test.p_value},
                         {"hazard", as_json(tail->hazard)}};
  json places{{"known", statistics.places.known}, {"upstream", statistics.places.upstream}};
  places["share_upstream"] = as_json(statistics.places.share_upstream);
  return {{"seeds", statistics.seeds},
          {"clogged", statistics.clogged},
          {"cut_off", statistics.seeds - statistics.clogged},
          {"passages", statistics.passages},
          {"largest", statistics.largest},
          {"jammed_starts", statistics.jammed_starts},
          {"mean", as_json(statistics.mean)},
          {"hazard", as_json(statistics.hazard)},
          {"hazard_bins", bins},
          {"geometric", geometric},
          {"packing_near_neck",
           {{"flowing", as_json(statistics.packing.flowing)}, {"at_end", as_json(statistics.packing.at_end)}}},
          {"clog_places", places}};
}

json as_json(const BurstOrder& order) {
  json fifths = json::array();
  for (const Fifth& fifth : order.fifths) fifths.push_back(as_json(fifth));
  return {{"bursts", order.bursts},
          {"fifths", fifths},
          {"trend", {{"correlation", order.trend.value}, {"p_value", order.trend.p_value}}},
          {"memory",
           {{"correlation", order.memory.value},
            {"low", number_or_null(order.memory_interval.low)},
            {"high", number_or_null(order.memory_interval.high)},
            {"p_value", order.memory.p_value}}},
          {"depends", order.depends},
          {"verdict", order.words}};
}

}  // namespace clogflow::postprocess
