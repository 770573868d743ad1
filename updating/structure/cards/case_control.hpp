// What the case control of a deck chooses for normal modes.
//
// Of several subcases one is solved: the first with ANALYSIS = MODES, else the
// first with METHOD, else the first. What stands above all subcases holds in
// each that has not its own.
//
// Source: MSC Nastran Quick Reference Guide, "Case control commands".
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

/// NAME(OPTION) = value, in capitals.
struct CaseCommand {
  std::string option;
  std::string value;
  std::string where;  ///< "file:line"
};

/// Of the subcase that is solved.
struct CaseControl {
  /// It says what is solved, so that sets which it does not choose are not in
  /// the model; false without a case control, or with titles alone.
  bool selects = false;
  int subcase = 0;                  ///< its number; 0 where there is none
  bool first = true;                ///< of the subcases
  bool normal_modes = false;        ///< SOL 103
  std::optional<int> spc_set;       ///< SPC = n
  std::vector<int> other_spc_sets;  ///< of other subcases, each once
  std::optional<int> mpc_set;       ///< MPC = n
  std::vector<std::string> stiffness_matrices;  ///< K2GG = name, ...
  std::vector<std::string> mass_matrices;       ///< M2GG = name, ...
  std::map<std::string, CaseCommand> commands;  ///< all, by whole names
};

/// Takes the executive and case control line by line.
class CaseReader {
 public:
  /// @param text without comment
  void add(const std::string& text, const std::string& where);

  [[nodiscard]] CaseControl result() const;

 private:
  using Commands = std::map<std::string, CaseCommand>;
  struct Subcase {
    int number = 0;
    Commands commands;
  };

  [[nodiscard]] std::size_t solved() const;
  [[nodiscard]] Commands of(std::size_t subcase) const;

  Commands above_;
  std::vector<Subcase> subcases_;
};

/// That of whole lines of a deck.
[[nodiscard]] CaseControl case_control(const std::vector<std::string>& lines);

}  // namespace tapfit::structure
