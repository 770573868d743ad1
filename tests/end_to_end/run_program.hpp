// Runs the real program as its users do, and keeps what it said.
#pragma once

#include <filesystem>
#include <string>

namespace tapfit::end_to_end {

struct ProgramResult {
  int exit_status = -1;  ///< -1 when it did not end by itself
  std::string out;
  std::string err;
};

/// Runs "tapfit ARGUMENTS" through the shell, without a terminal.
/// @param arguments quoted for the shell where needed
[[nodiscard]] ProgramResult run_tapfit(const std::string& arguments);

/// An empty folder of this process's own below the system's temporary folder,
/// removed when it ends.
[[nodiscard]] std::filesystem::path scratch_folder(const std::string& name);

/// The same for the running test, by whose name it is called; made once.
[[nodiscard]] std::filesystem::path fresh_folder();

void write_file(const std::filesystem::path& path, const std::string& text);
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

[[nodiscard]] inline bool holds(const std::string& text,
                                const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace tapfit::end_to_end
