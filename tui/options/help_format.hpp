// How the help of commands is set: values in plain words, where the parser has
// its own ("TEXT:{H1,H2}", "FLOAT:NONNEGATIVE x 2"); an example at the end.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace tapfit::tui {

class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat();

  /// "--csv[=TABLE]" where the value may be left out.
  [[nodiscard]] std::string make_option_name(const CLI::Option* option,
                                             bool is_positional) const override;

  /// "H1|H2|Hv", "LOW HIGH", "NUMBER (not with --sigma)".
  [[nodiscard]] std::string make_option_opts(
      const CLI::Option* option) const override;
};

/// "Example:" and a command line that does something useful with the
/// demonstration; empty for commands without one.
[[nodiscard]] std::string example_of(const std::string& command);

}  // namespace tapfit::tui
