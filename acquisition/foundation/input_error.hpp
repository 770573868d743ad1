// The room acquisition/foundation. What all other rooms stand on: the one
// exception for bad input, output files, text of any encoding, threads,
// progress, random numbers, units, degrees of freedom, files kept from run to
// run. In:  Nothing of the test itself comes in: no file format, no signal.
// Out: Small functions and plain types.
// May include: its row in CONTRIBUTING.md.
//
// The one exception for bad input: what is wrong, where, and what to try.
#pragma once

#include <stdexcept>
#include <string>

namespace tapfit {

/// Input that cannot be used as it stands.
class InputError : public std::runtime_error {
 public:
  /// @param what the fault, in one sentence without the place
  /// @param where file, line or field, for example "test.json: runs[2].file"
  /// @param remedy what the user can try, in one sentence
  InputError(const std::string& what, std::string where, std::string remedy);

  /// The fault alone; what() names place and remedy, too.
  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] const std::string& where() const { return where_; }
  [[nodiscard]] const std::string& remedy() const { return remedy_; }

 private:
  std::string fault_;
  std::string where_;
  std::string remedy_;
};

}  // namespace tapfit
