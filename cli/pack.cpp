// clog pack: the run files of a finished ensemble in one file.
#include <memory>

#include "cli/output.hpp"
#include "cli/verbs.hpp"
#include "ensemble/packing.hpp"
#include "ensemble/ranks.hpp"

namespace clogflow::cli {

void add_pack(CLI::App& app) {
  auto* verb = app.add_subcommand("pack", "all run files of a finished ensemble in one file");
  auto job = std::make_shared<Packing>();
  verb->add_option("folder", job->folder, "folder with run_*.h5; of a sweep one of its folders")->required();
  verb->add_option("--out", job->pack, "file to write, which clog stats and clog info read as they do the folder")
      ->required();
  verb->add_flag("--remove", job->remove, "then remove the run files, each of which was compared with its copy");
  verb->callback([job] {
    const Ranks ranks;
    if (!ranks.is_first()) return;
    const std::size_t runs = pack_ensemble(*job);
    print_result("{}: {} runs, each compared with its file{}\n", job->pack.string(), runs,
                 job->remove ? "; the files are removed" : "");
  });
}

}  // namespace clogflow::cli
