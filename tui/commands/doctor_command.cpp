#include "tui/commands/doctor_command.hpp"

#include "tui/commands/commands.hpp"
#include "tui/options/library_versions.hpp"
#include "tui/report/json_text.hpp"
#include "tui/screen/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

using nlohmann::ordered_json;

constexpr int least_width = 80;
constexpr int least_height = 24;
constexpr int colours_of_heat = 256;
constexpr double gigabyte = 1e9;

std::string size_text(double bytes) {
  return bytes < gigabyte ? fmt::format("{:.0f} MB", bytes / 1e6)
                          : fmt::format("{:.1f} GB", bytes / gigabyte);
}

HealthCheck terminal_check(const TerminalTraits& terminal) {
  HealthCheck check{"terminal", terminal.kind, "the screens can be shown", ""};
  if (!terminal.is_one) {
    check.found = "none: input or output is a file or pipe";
    check.meaning = "the screens cannot be shown, commands work";
    check.advice = "start it in a terminal";
  } else if (!terminal.known) {
    check.found += " (not known here)";
    check.meaning = "it is taken for an xterm";
    check.advice =
        "if the picture is garbled, try TERM=xterm-256color or TERM=vt100";
  } else if (!terminal.places_cursor) {
    check.meaning = "it cannot place its cursor: no screens, commands work";
    check.advice = "try TERM=xterm-256color or TERM=vt100";
  }
  return check;
}

HealthCheck colours_check(const Surroundings& here) {
  const int colours = here.terminal.colours;
  HealthCheck check{"colours",
                    colours > 0 ? std::to_string(colours) : "none",
                    "maps are shaded by size",
                    ""};
  if (here.no_colour) {
    check.found += ", switched off by NO_COLOR";
    check.meaning = "curves are told apart by their lines";
    check.advice = "unset NO_COLOR for colours";
  } else if (colours < colours_of_heat) {
    check.meaning = "of maps only the largest entries stand out";
    check.advice = "most terminals have 256: try TERM=xterm-256color";
  }
  return check;
}

HealthCheck locale_check(const Surroundings& here) {
  if (here.utf8) {
    return {"locale", here.locale, "curves are drawn in braille dots", ""};
  }
  return {"locale",
          here.locale + ", not UTF-8",
          "all is drawn in ASCII, curves are coarse",
          "set LANG=C.UTF-8 or another locale of UTF-8 (locale -a lists them)"};
}

HealthCheck graphics_check(const TerminalGraphics& has,
                           const Settings& settings) {
  const Graphics best = has.best();
  if (best == Graphics::None) {
    return {"graphics",
            "none",
            "curves are drawn in characters; kitty's graphics or sixels would "
            "draw them in pixels",
            ""};
  }
  HealthCheck check{
      "graphics",
      fmt::format("{}, cells of {} x {} pixels",
                  best == Graphics::Kitty ? "kitty's protocol" : "sixels",
                  has.cell.width,
                  has.cell.height),
      "curves are drawn in pixels; --graphics off draws them in characters",
      ""};
  if (settings.graphics == GraphicsWish::Off) {
    check.found += ", switched off by the settings";
    check.meaning = "curves are drawn in characters";
  }
  return check;
}

HealthCheck size_check(const TerminalTraits& terminal) {
  HealthCheck check{
      "size",
      fmt::format("{} x {} cells", terminal.width, terminal.height),
      "lists, maps and plots stand beside each other from 110 columns on",
      ""};
  if (terminal.width <= 0) {
    check.found = "not known";
    check.meaning = "it is asked for when the screens are shown";
  } else if (terminal.width < least_width || terminal.height < least_height) {
    check.meaning = fmt::format(
        "the screens need {} x {} cells", least_width, least_height);
    check.advice = "enlarge the window, or take a smaller font";
  }
  return check;
}

HealthCheck mouse_check(const TerminalTraits& terminal) {
  if (terminal.mouse) {
    return {"mouse",
            "yes",
            "clicks choose rows, keys and places in plots; --no-mouse leaves "
            "it to the terminal",
            ""};
  }
  return {
      "mouse",
      "none",
      "everything can be done by keys",
      "for clicks, take a terminal that reports them (TERM=xterm-256color)"};
}

HealthCheck clipboard_check(const Surroundings& here) {
  HealthCheck check{"clipboard",
                    here.in_tmux ? "inside tmux" : "by the terminal (OSC 52)",
                    "y copies a plot's numbers, through ssh too",
                    ""};
  if (here.in_tmux) {
    check.meaning = "y copies a plot's numbers where tmux passes them on";
    check.advice = "in tmux: set -s set-clipboard on";
  }
  return check;
}

HealthCheck settings_check(const Settings& settings) {
  if (!settings.file) {
    const auto file = settings_file();
    return {"settings",
            "none",
            file ? "colours, axes and keys may be set in " + file->string()
                 : "colours, axes and keys are the usual ones",
            ""};
  }
  HealthCheck check{"settings",
                    settings.file->string(),
                    "colours, axes and keys are as set there",
                    ""};
  if (!settings.faults.empty()) {
    check.meaning = "what is wrong there is as usual";
    check.advice = fmt::format("{}", fmt::join(settings.faults, "; "));
  }
  return check;
}

HealthCheck cache_check(const Surroundings& here) {
  if (!here.cache) {
    return {
        "cache",
        "none",
        "models and diagnoses are worked out anew each time",
        "unset TAPFIT_NO_CACHE, and set XDG_CACHE_HOME or HOME to a folder"};
  }
  HealthCheck check{
      "cache",
      fmt::format("{}, {}",
                  here.cache->string(),
                  size_text(static_cast<double>(here.cache_bytes))),
      "at most 1 GB; it can be deleted at any time",
      ""};
  if (!here.cache_writable) {
    check.found += ", not writable";
    check.meaning = "models and diagnoses are worked out anew each time";
    check.advice = "make it writable, or set XDG_CACHE_HOME to another folder";
  }
  return check;
}

HealthCheck memory_check(const Surroundings& here) {
  HealthCheck check{"memory",
                    fmt::format("{} of {} free",
                                size_text(here.free_bytes),
                                size_text(here.memory_bytes)),
                    "recordings may unpack to half of it",
                    ""};
  if (here.memory_bytes <= 0.0) {
    check.found = "not known";
  } else if (here.free_bytes < gigabyte) {
    check.meaning = "a fine mesh or a long recording may not fit";
    check.advice =
        "close what else runs; tapfit replay works through long recordings";
  }
  return check;
}

HealthCheck threads_check(const Surroundings& here) {
  HealthCheck check{"threads",
                    std::to_string(here.threads),
                    "a diagnosis takes about as many times less",
                    ""};
  if (!here.omp_threads.empty()) {
    check.found += ", OMP_NUM_THREADS=" + here.omp_threads;
  }
  if (here.threads == 1) {
    check.meaning = "a diagnosis has one core for itself";
    check.advice = "allow it more cores, where this is a virtual machine";
  }
  return check;
}

ordered_json doctor_json(const std::vector<HealthCheck>& checks) {
  ordered_json libraries = ordered_json::object();
  for (const auto& [name, version] : library_versions()) {
    libraries[name] = version;
  }
  ordered_json list = ordered_json::array();
  for (const HealthCheck& check : checks) {
    list.push_back({{"name", check.name},
                    {"ok", check.advice.empty()},
                    {"found", check.found},
                    {"meaning", check.meaning},
                    {"advice", check.advice}});
  }
  return {{"checks", std::move(list)}, {"libraries", std::move(libraries)}};
}

std::string doctor_text(const std::vector<HealthCheck>& checks) {
  std::string text;
  std::size_t advised = 0;
  for (const HealthCheck& check : checks) {
    text += fmt::format("  {:<4}  {:<9}  {}\n",
                        check.advice.empty() ? "ok" : "look",
                        check.name,
                        check.found);
    text += fmt::format("{:19}{}\n", "", check.meaning);
    if (check.advice.empty()) continue;
    ++advised;
    for (const std::string& line : wrapped("do: " + check.advice, 61)) {
      text += fmt::format("{:19}{}\n", "", line);
    }
  }
  text +=
      advised == 0
          ? "All is well.\n"
          : fmt::format("{} of {} could be better.\n", advised, checks.size());
  for (const auto& [name, version] : library_versions()) {
    text += fmt::format("  {} {}\n", name, version);
  }
  return text;
}

}  // namespace

std::vector<HealthCheck> health_checks(const Surroundings& here,
                                       const Settings& settings) {
  return {terminal_check(here.terminal),
          size_check(here.terminal),
          colours_check(here),
          locale_check(here),
          graphics_check(here.terminal.graphics, settings),
          mouse_check(here.terminal),
          clipboard_check(here),
          settings_check(settings),
          cache_check(here),
          memory_check(here),
          threads_check(here)};
}

std::string doctor_command(const CommandOptions& options, const Progress&) {
  const std::vector<HealthCheck> checks =
      health_checks(look_around(), read_settings(settings_file()));
  return options.json ? json_text(doctor_json(checks)) : doctor_text(checks);
}

}  // namespace tapfit::tui
