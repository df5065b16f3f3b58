// Writes docs/reports/verification.md: every verified number beside its reference. Usage:
// verification_report [FILE]; without a file to standard output. Exit status 1 if a limit is exceeded.
#include <cstdio>
#include <fstream>

#include <fmt/format.h>

#include "tests/verification/check.hpp"

using clogflow::verification::Check;
using clogflow::verification::Group;

namespace {

constexpr const char* introduction = R"(# Verification

The particle solver against published benchmarks, closed forms and conservation laws. Made by

    build/release/bin/verification_report docs/reports/verification.md

and asserted, with the same numbers and limits, by the test program `test_verification`. *Error* is relative to
the reference, or absolute (marked "abs") where the reference is zero or a curve with zeros. Chung & Ooi: "Benchmark tests for
verifying discrete element modelling codes at particle impact level", Granular Matter 13 (2011) 643.

The same states in LAMMPS (Debian package `lammps`) are compared by two scripts, which print the differences, and say at their head
where the laws are equal and where each limit comes from:

    tests/verification/peer_lammps build/release/bin/clog     # contact list, normal and sliding forces
    tests/verification/peer_turning build/release/bin/clog    # rolling and torsion

1000 settled spheres in a box, LAMMPS of 29 Sep 2021 (update 2): the 1633 contacts are the same pairs, forces at rest and with dashpots differ by 2e-13 of
the largest (limit 1e-9), rolling and torsion with history by 2e-12. Sliding with history differs in torques by 1.5e-3 after 1 step (limit 2.7e-3)
and by 1 % after 400 steps (limit 2 %): for the velocity of the contact area LAMMPS takes the lever r and we r - delta/2, the arm that both use for
the torque, a share delta/(2 r) <= 2.7e-3 of the rotational part; later the motion itself grows apart through collisions.
)";

/// A name as a cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.replace(at, 1, "\\|");
  return text;
}

std::string row(const Check& c) {
  return fmt::format("| {} | {:.6g} | {:.6g} | {:.2e}{} | {:.1e} | {} |\n", cell(c.name), c.reference, c.ours,
                     c.error(), c.relative ? "" : " abs", c.limit, c.passed() ? "yes" : "**NO**");
}

}  // namespace

int main(int argc, char** argv) {
  std::string page = introduction;
  int failed = 0, count = 0;
  for (const auto& entry : clogflow::verification::all_groups()) {
    const Group group = entry.run();
    page += fmt::format(
        "\n## {}\n\n{}\n\n| test | reference | ours | error | limit | within |\n| --- | ---: | ---: | ---: | ---: | "
        "--- |\n",
        group.title, group.remark);
    for (const Check& check : group.checks) {
      page += row(check);
      ++count;
      failed += !check.passed();
    }
  }
  page += fmt::format("\n{} of {} numbers within their limits.\n", count - failed, count);
  if (argc > 1) {
    std::ofstream(argv[1]) << page;
  } else {
    std::fputs(page.c_str(), stdout);
  }
  return failed ? 1 : 0;
}
