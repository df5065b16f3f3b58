// Who may change a flow case: one process at a time, its Allrun included.
#pragma once

#include <filesystem>
#include <string>

namespace clogflow {

/// The lock that foam_case/Allrun takes too (flock on the file `lock` of the case), held until the
/// end of the scope or of the process. A file system without locks is gone on with, unlocked.
class CaseLock {
public:
  /// \throws Error when the file cannot be made
  explicit CaseLock(const std::filesystem::path& folder);
  ~CaseLock();
  CaseLock(const CaseLock&) = delete;
  CaseLock& operator=(const CaseLock&) = delete;

  /// \return whether it is ours, at once
  bool take();
  /// The same, waiting for as long as another call takes to write a case.
  bool take_patiently();
  /// Who has it, as it says itself: "process 123 on host", or "another process".
  std::string holder() const;

private:
  std::filesystem::path file_;
  int descriptor_;
};

}  // namespace clogflow
