#include "tui/report/report_traceability.hpp"

#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace tapfit::tui {
namespace {

using acquisition::ChannelNotes;

const char* quantity_words(acquisition::Quantity quantity) {
  return quantity == acquisition::Quantity::Force          ? "force"
         : quantity == acquisition::Quantity::Acceleration ? "acceleration"
         : quantity == acquisition::Quantity::Velocity     ? "velocity"
                                                           : "displacement";
}

std::string or_dash(const std::string& text) {
  return text.empty() ? "–" : text;
}

std::string sensitivity_words(const acquisition::Channel& channel) {
  const bool ratio = channel.unit.find('/') != std::string::npos;
  return typeset(fmt::format("{} mV/{}{}{}",
                             number(1e3 * channel.sensitivity),
                             ratio ? "(" : "",
                             channel.unit,
                             ratio ? ")" : ""));
}

const ChannelNotes& notes_of(const ReportData& data,
                             const acquisition::Channel& channel) {
  static const ChannelNotes none;
  const auto found = data.notes.channels.find(channel.name);
  return found == data.notes.channels.end() ? none : found->second;
}

std::string other_words(const ChannelNotes& notes) {
  std::string text;
  for (const auto& [name, value] : notes.others) {
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", name, value);
  }
  return text;
}

/// A column of the notes that is printed where any channel has it.
struct NoteColumn {
  const char* heading;
  std::string (*written)(const ChannelNotes&);
  bool always = false;
};
constexpr std::array<NoteColumn, 5> note_columns{
    {{"<type", [](const ChannelNotes& n) { return n.type; }},
     {"<serial number", [](const ChannelNotes& n) { return n.serial; }, true},
     {"<calibrated", [](const ChannelNotes& n) { return n.calibrated; }, true},
     {"<due", [](const ChannelNotes& n) { return n.calibration_due; }},
     {"<notes", other_words}}};

DataTable channel_table(const ReportData& data) {
  DataTable table{
      "Channels",
      {"<channel", "<quantity", "sensitivity", "full scale", "mass"},
      {}};
  std::vector<NoteColumn> columns;
  for (const NoteColumn& column : note_columns) {
    const auto told = [&](const acquisition::Channel& channel) {
      return !column.written(notes_of(data, channel)).empty();
    };
    if (!column.always && std::ranges::none_of(data.bundle.channels, told)) {
      continue;
    }
    columns.push_back(column);
    table.heading.emplace_back(column.heading);
  }
  for (const acquisition::Channel& channel : data.bundle.channels) {
    table.rows.push_back(
        {channel.name,
         quantity_words(channel.quantity),
         sensitivity_words(channel),
         number(channel.full_scale_volts) + " V",
         channel.mass_kg ? number(1e3 * *channel.mass_kg) + " g" : "–"});
    for (const NoteColumn& column : columns) {
      table.rows.back().push_back(
          or_dash(column.written(notes_of(data, channel))));
    }
  }
  return table;
}

std::string fact(const ReportData& data, const char* name) {
  for (const auto& [known, value] : data.notes.facts) {
    if (known == name) return value;
  }
  return {};
}

/// "2026-03" and what may follow it.
bool is_date(const std::string& text) {
  constexpr std::string_view form = "0000-00";
  if (text.size() < form.size()) return false;
  for (std::size_t k = 0; k < form.size(); ++k) {
    const bool digit = std::isdigit(static_cast<unsigned char>(text[k])) != 0;
    if (form[k] == '0' ? !digit : text[k] != form[k]) return false;
  }
  return true;
}

/// To the precision of both: no month is before a day in it.
bool is_before(const std::string& one, const std::string& other) {
  if (!is_date(one) || !is_date(other)) return false;
  const std::size_t both =
      std::min({one.size(), other.size(), std::size_t{10}});
  return one.substr(0, both) < other.substr(0, both);
}

void add_date_remarks(const ReportData& data,
                      std::vector<std::string>& remarks) {
  const std::string tested = fact(data, "date");
  for (const acquisition::Channel& channel : data.bundle.channels) {
    const ChannelNotes& notes = notes_of(data, channel);
    if (is_before(notes.calibration_due, tested)) {
      remarks.push_back(fmt::format(
          "The calibration of {} was due on {}, before the test of {}.",
          channel.name,
          notes.calibration_due,
          tested));
    }
    if (is_before(tested, notes.calibrated)) {
      remarks.push_back(
          fmt::format("{} was calibrated on {}, after the test of {}.",
                      channel.name,
                      notes.calibrated,
                      tested));
    }
  }
}

/// "serial of acc1 and acc2".
std::string lacking(const ReportData& data,
                    const char* key,
                    std::string ChannelNotes::*field) {
  std::vector<std::string> channels;
  for (const acquisition::Channel& channel : data.bundle.channels) {
    if ((notes_of(data, channel).*field).empty()) {
      channels.push_back(channel.name);
    }
  }
  if (channels.empty()) return {};
  const bool none = channels.size() == data.bundle.channels.size();
  return fmt::format(
      "{} of {}", key, none ? "the channels" : enumerated(channels));
}

std::string missing_words(const ReportData& data) {
  std::vector<std::string> missing;
  const auto add = [&missing](const std::string& what) {
    if (!what.empty()) missing.push_back(what);
  };
  const auto ask = [&](const char* name, const char* key) {
    if (fact(data, name).empty()) add(key);
  };
  ask("date", "date");
  ask("operator", "operator");
  if (!data.bundle.runs.empty()) {
    ask("hammer tip", "hammer_tip");
    ask("temperature", "temperature_c");
    add(lacking(data, "serial", &ChannelNotes::serial));
    add(lacking(data, "calibrated", &ChannelNotes::calibrated));
  }
  if (missing.empty()) return {};
  return fmt::format("To make the test traceable, test.json lacks: {}.",
                     fmt::join(missing, "; "));
}

}  // namespace

std::vector<std::string> traceability_remarks(const ReportData& data) {
  std::vector<std::string> remarks;
  add_date_remarks(data, remarks);
  if (std::string missing = missing_words(data); !missing.empty()) {
    remarks.push_back(std::move(missing));
  }
  return remarks;
}

std::vector<Part> traceability_parts(const ReportData& data) {
  std::vector<Part> parts;
  if (!data.bundle.channels.empty()) parts.emplace_back(channel_table(data));
  for (std::string& remark : traceability_remarks(data)) {
    parts.emplace_back(Paragraph{std::move(remark), Paragraph::Kind::Small});
  }
  return parts;
}

}  // namespace tapfit::tui
