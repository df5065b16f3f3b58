// The words of a text STL file, line by line: however long the file is, a line of it is in memory.
#pragma once

#include <istream>
#include <string>
#include <string_view>

namespace clogflow {

/// Keywords come in any case, in one line or many; a byte order mark, blank lines and lines that
/// begin as a comment (# // ; !) are passed over.
class StlWords {
public:
  explicit StlWords(std::istream& stream) : stream_(stream) {}

  /// The next word, valid until the next call; empty at the end.
  std::string_view next();

  /// The rest of the line without the blanks around it: the name after `solid`. Where a facet
  /// follows in the same line, what stands before it.
  std::string name();

  /// Of the line that the last word stands in, from 1.
  std::size_t line() const { return number_; }

private:
  bool next_line();

  std::istream& stream_;
  std::string line_;
  std::size_t at_ = 0, number_ = 0;
};

/// Compares without regard to case. \param lower  in lower case
bool is_word(std::string_view word, std::string_view lower);

/// Whether the beginning of a file is that of a text STL file.
bool begins_as_text(std::string_view head);

}  // namespace clogflow
