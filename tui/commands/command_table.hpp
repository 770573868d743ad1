// The commands that take a test, deck or file and print what they find: their
// names, what they do, the options that they take.
#pragma once

#include "tui/options/command.hpp"

#include <span>

namespace tapfit::tui {

struct CommandEntry {
  /// Options a command has besides --json.
  enum Option : unsigned {
    None = 0,
    Uff = 1,
    DeckFile = 2,
    Output = 4,
    Effects = 8,
    Modes = 16,
    Node = 32,
    SavedFile = 64,
    TextOnly = 128,
    Free = 256,
    Regularisation = 512,
    Identify = 1024,
    Mac = 2048,
    Speed = 4096,
    Estimate = 8192,
    Mass = 16384,
    ByHand = 32768,
    Pairs = 65536,
    BodyMass = 131072,
    Robustness = 262144,
    Forecast = 524288,
    Several = 1048576,
  };

  const char* name;
  const char* does;
  Command command;
  unsigned extras;               ///< of Option
  const char* table = nullptr;   ///< what --csv prints of its JSON
  const char* input = "BUNDLE";  ///< null: none is read
  const char* alias = nullptr;   ///< an older name
};

/// In the order of the work.
[[nodiscard]] std::span<const CommandEntry> command_table();

}  // namespace tapfit::tui
