// The program: reads the command line, runs one command or the terminal, and
// turns every fault into a message and an exit status.
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/reuse_memory.hpp"
#include "tui/app/app.hpp"
#include "tui/commands/command_line.hpp"
#include "tui/options/csv_table.hpp"
#include "tui/options/exit_status.hpp"
#include "tui/options/progress_line.hpp"
#include "tui/options/standard_streams.hpp"
#include "updating/export/outside_files.hpp"

#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>
#include <unistd.h>
#include <variant>
#include <vector>

namespace {

using tapfit::tui::CommandLineAnswer;
using tapfit::tui::ExitStatus;
using tapfit::tui::Invocation;
using tapfit::tui::print;
using tapfit::tui::say;

void check_is_there(const std::filesystem::path& input) {
  std::error_code fault;
  if (input.empty() || std::filesystem::exists(input, fault)) return;
  throw tapfit::InputError("is not there",
                           input.string(),
                           "give the folder of a test, with its test.json, or "
                           "a universal file");
}

int open_terminal(const Invocation& invocation) {
  check_is_there(invocation.options.input);
  const bool replay = invocation.app.keys_file.has_value();
  if (!replay && (isatty(STDIN_FILENO) == 0 || isatty(STDOUT_FILENO) == 0)) {
    say(!invocation.help.empty() ? invocation.help
        : invocation.options.input.empty()
            ? "tapfit: this is no terminal, and the tour needs one\n"
            : fmt::format("tapfit: this is no terminal; try 'tapfit run {}'\n",
                          invocation.options.input.string()));
    return ExitStatus::CommandLineAtFault;
  }
  tapfit::tui::AppOptions options = invocation.app;
  options.inside = invocation.options.inside;
  return tapfit::tui::run_app(invocation.options.input, options);
}

int run_command(const Invocation& invocation) {
  tapfit::tui::ProgressLine line(isatty(STDERR_FILENO) != 0);
  const std::string output =
      invocation.command(invocation.options, line.progress());
  const std::string& table = invocation.options.csv;
  const std::string printed =
      table.empty() ? output : tapfit::tui::csv_table(output, table);
  line.clear();
  print(printed);
  return ExitStatus::Done;
}

// Commands that read their own command line.
int run_own(const Invocation& invocation) {
  std::vector<const char*> argv{invocation.name.c_str()};
  for (const std::string& argument : invocation.passed_on) {
    argv.push_back(argument.c_str());
  }
  argv.push_back(nullptr);
  const int argc = static_cast<int>(argv.size()) - 1;
  tapfit::tui::ProgressLine line(false);
  return invocation.own(argc, argv.data(), line.progress());
}

int tapfit_main(int argc, const char* const* argv) {
  const auto parsed = tapfit::tui::parse_command_line(argc, argv);
  if (const auto* answer = std::get_if<CommandLineAnswer>(&parsed)) {
    answer->exit_status == ExitStatus::Done ? print(answer->text)
                                            : say(answer->text);
    return answer->exit_status;
  }
  const auto& invocation = std::get<Invocation>(parsed);
  if (invocation.own != nullptr) return run_own(invocation);
  if (invocation.options.inside && !invocation.options.input.empty()) {
    tapfit::updating::check_inside(invocation.options.input);
  }
  return invocation.command != nullptr ? run_command(invocation)
                                       : open_terminal(invocation);
}

}  // namespace

int main(int argc, char** argv) {
  tapfit::reuse_memory();
  // A file beyond the shell's limit fails to be written like on a full disk.
  (void)std::signal(SIGXFSZ, SIG_IGN);
  try {
    return tapfit_main(argc, argv);
  } catch (const tapfit::tui::NoSuchTable& error) {
    say(fmt::format("tapfit: {}\n", error.what()));
    return ExitStatus::CommandLineAtFault;
  } catch (const tapfit::InputError& error) {
    say(fmt::format("tapfit: {}\n", error.what()));
    return ExitStatus::InputAtFault;
  } catch (const tapfit::Stopped&) {
    say("tapfit: stopped\n");
    return ExitStatus::StoppedByUser;
  } catch (const std::bad_alloc&) {
    // Sizes that files announce are checked where they are read; what is left
    // is a test that is larger than this machine.
    say("tapfit: the test needs more memory than there is (leave runs, points "
        "or modes out, take a coarser deck, or work through long recordings "
        "with tapfit replay)\n");
    return ExitStatus::InputAtFault;
  } catch (const std::filesystem::filesystem_error& error) {
    say(fmt::format("tapfit: {}\n", error.what()));
    return ExitStatus::InputAtFault;
  } catch (const std::exception& error) {
    say(fmt::format("tapfit: our own fault, please report it: {}\n",
                    error.what()));
    return ExitStatus::OwnFault;
  }
}
