// The file of --log: what a verb says, each line with its time.
#pragma once

#include <filesystem>
#include <string>

namespace clogflow::cli {

/// Lines are added to what earlier calls and other ranks wrote, each by one write, so that none is torn.
class LogFile {
public:
  LogFile() = default;
  ~LogFile();
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  /// \param call  the first line of rank 0
  /// \throws Error unless the file can be written, and is new or a log
  void open(const std::filesystem::path& file, const std::string& call);

  /// Every line that the text ends; the rest waits for its end. Nothing when none is open.
  void add(const std::string& text);

  /// Whether everything could be written.
  bool is_whole() const { return whole_; }

private:
  int descriptor_ = -1;
  bool whole_ = true;
  std::string rest_;
};

}  // namespace clogflow::cli
