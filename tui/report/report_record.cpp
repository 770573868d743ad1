#include "tui/report/report_record.hpp"

#include "acquisition/foundation/sha256.hpp"
#include "acquisition/readers/mapped_file.hpp"
#include "tui/report/report_words.hpp"
#include "tui/screen/number.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_read(const ReportData& data) {
  std::vector<fs::path> files;
  const auto add = [&](const fs::path& file) {
    std::error_code ignored;
    if (fs::is_regular_file(file, ignored) &&
        std::ranges::find(files, file) == files.end()) {
      files.push_back(file);
    }
  };
  add(data.path);
  add(data.path / "test.json");
  if (data.bundle.deck) add(*data.bundle.deck);
  if (data.bundle.matrices) {
    add(data.bundle.matrices->stiffness);
    add(data.bundle.matrices->mass);
    add(data.bundle.matrices->dofs);
  }
  if (data.bundle.frfs) add(*data.bundle.frfs);
  if (data.bundle.modes) add(data.bundle.modes->file);
  if (data.bundle.geometry) add(data.bundle.geometry->file);
  for (const acquisition::Run& run : data.bundle.runs) add(run.file);
  return files;
}

std::string digest_of_file(const fs::path& file) {
  const acquisition::MappedFile bytes(file);
  return bytes.reading([&bytes] { return acquisition::sha256(bytes.text()); });
}

std::string library_words(const ReportData& data) {
  std::vector<std::string> names;
  for (const auto& [name, version] : data.versions) {
    if (name != "tapfit") names.push_back(name + " " + version);
  }
  return names.empty() ? "" : " with " + enumerated(names);
}

Section file_section(const ReportData& data) {
  DataTable table{"", {"<file", "bytes", "<SHA-256"}, {}};
  for (const fs::path& file : files_read(data)) {
    std::error_code ignored;
    table.rows.push_back({file.filename().string(),
                          fmt::format("{}", fs::file_size(file, ignored)),
                          digest_of_file(file)});
  }
  return {
      "Files",
      {table,
       Paragraph{fmt::format("Worked out by tapfit {}{}. SHA-256 digests are "
                             "those of sha256sum and its kin.",
                             TAPFIT_VERSION,
                             library_words(data)),
                 Paragraph::Kind::Small}}};
}

Section settings_section(const ReportData& data) {
  BulletList list;
  if (data.hits) {
    const acquisition::HitSet& hits = *data.hits;
    const double rate = hits.sample_rate_hz;
    list.items.push_back(fmt::format(
        "Sampling rate {} Hz; blocks of {} "
        "samples ({} s), of these {} before the "
        "trigger.",
        number(rate, 6),
        hits.block,
        number(static_cast<double>(hits.block) / std::max(rate, 1e-9)),
        hits.pre_trigger));
    for (const std::string& statement : hits.statements) {
      list.items.push_back(capitalised(typeset(statement)));
    }
    list.items.emplace_back(
        "FRFs: estimator H1, force and exponential window.");
  }
  if (data.frfs.lines() > 1) {
    const Eigen::VectorXd hz = data.frfs.frequency_hz();
    list.items.push_back(fmt::format("FRFs on {} lines from {} to {} Hz.",
                                     data.frfs.lines(),
                                     number(hz(0)),
                                     number(hz(hz.size() - 1))));
  }
  if (data.model) {
    if (!data.model->after.contour.empty()) {
      list.items.push_back(
          (data.bundle.modes ? "Errors of modes: " : "Errors of FRFs: ") +
          contour_words(data.model->after.contour) + ".");
    }
    for (const acquisition::UncertainProperty& one : data.bundle.uncertain) {
      list.items.push_back(
          fmt::format("{} of {} {} is uncertain by {} % (one standard "
                      "deviation).",
                      one.property,
                      one.card,
                      one.id,
                      number(one.sd_percent)));
    }
  }
  return {"Settings", {list}};
}

}  // namespace

std::vector<Section> record_sections(const ReportData& data) {
  std::vector<Section> sections;
  if (!data.warnings.empty()) {
    BulletList list;
    for (const std::string& warning : data.warnings) {
      list.items.push_back(capitalised(typeset(warning)));
    }
    sections.push_back({"Notes and warnings", {list}});
  }
  sections.push_back(settings_section(data));
  sections.push_back(file_section(data));
  return sections;
}

}  // namespace tapfit::tui
