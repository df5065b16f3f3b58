#include "postprocess/events/run_digest.hpp"

#include <algorithm>

#include "coupling/files/run_file.hpp"

namespace clogflow::postprocess {

RunDigest DigestMaker::digest_of(const std::filesystem::path& file) {
  RunDigest result;
  try {
    digest(file, result);
  } catch (const std::exception& error) {
    result.error = error.what();
  }
  return result;
}

void DigestMaker::digest(const std::filesystem::path& file, RunDigest& digest) {
  const RunData run = read_run_events(file);
  digest.necks = run.record.necks.value_or(1);
  const Kind& kind = kind_of(run, file, digest);
  digest.record.seed = run.seed;
  digest.error = kind.error;
  if (!kind.error.empty()) return;
  digest.record = record_of(run, kind.scene, kind.scale);
  for (std::int64_t k = 0; digest.necks > 1 && k < digest.necks; ++k)
    digest.of_necks.push_back(record_of(through_neck(run, k), kind.scene, kind.scale));
}

const DigestMaker::Kind& DigestMaker::kind_of(const RunData& run, const std::filesystem::path& file,
                                              RunDigest& digest) {
  SceneLines lines = scene_lines(run.scene_text);
  const auto found = std::ranges::find(kinds_, lines, &Kind::lines);
  digest.kind = static_cast<std::size_t>(found - kinds_.begin());
  digest.kind_known = true;
  digest.kind_is_new = found == kinds_.end();
  if (!digest.kind_is_new) return *found;
  digest.new_kind = {run.scene_text, record_text(run.record), lines};
  Kind kind{.lines = std::move(lines), .scene = {}, .scale = {}, .error = ""};
  try {
    kind.scene = parse_scene(run.scene_text, file.string());
    kind.scale = clog_scale(kind.scene, threshold_, file.string());
  } catch (const std::exception& error) {
    kind.error = error.what();
  }
  kinds_.push_back(std::move(kind));
  return kinds_.back();
}

}  // namespace clogflow::postprocess
