#include "acquisition/foundation/output_file.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

InputError unwritable(const fs::path& target) {
  return {"cannot be written",
          target.string(),
          "check the folder, your rights to it and the space left"};
}

// Told apart from those of other threads and other runs of the program, and
// from anything else that is there.
fs::path unfinished_name(const fs::path& target) {
  static std::atomic<unsigned> count = 0;
  std::error_code fault;
  fs::path name;
  do {
    name = target;
    name += fmt::format(".{}-{}.part", ::getpid(), ++count);
  } while (fs::exists(fs::symlink_status(name, fault)));
  return name;
}

bool may_be_written(const fs::path& there) {
  return ::access(there.c_str(), W_OK) == 0;
}

// Also where the file is not there that a link names.
fs::path behind_links(fs::path target) {
  constexpr int most = 40;  // as the system follows before it tells of a loop
  std::error_code fault;
  for (int k = 0; k < most && fs::is_symlink(target, fault); ++k) {
    target = target.parent_path() / fs::read_symlink(target, fault);
  }
  return target;
}

// A new file has the rights of the one that it replaces.
void take_over_rights(const fs::path& from, const fs::path& to) {
  std::error_code fault;
  const fs::perms rights = fs::status(from, fault).permissions();
  if (!fault && fs::exists(from, fault)) fs::permissions(to, rights, fault);
}

bool rename_to_free(const fs::path& file, const fs::path& place) {
  return ::renameat2(AT_FDCWD,
                     file.c_str(),
                     AT_FDCWD,
                     place.c_str(),
                     RENAME_NOREPLACE) == 0;
}

// Where nothing may be replaced the system looks and renames as one; on file
// systems that cannot, the last look was just before.
void put_in_place(const fs::path& file,
                  const fs::path& place,
                  const OutputRule& rule) {
  rule.check(place);
  if (!rule.force) {
    if (rename_to_free(file, place)) return;
    if (errno != EINVAL && errno != ENOSYS) throw unwritable(place);
  }
  take_over_rights(place, file);
  std::error_code fault;
  fs::rename(file, place, fault);
  if (fault) throw unwritable(place);
}

}  // namespace

OutputFile::OutputFile(const fs::path& target, OutputRule rule)
    : target_(behind_links(target)), rule_(std::move(rule)) {
  rule_.check(target);
  std::error_code fault;
  const fs::file_status there = fs::status(target_, fault);
  const bool exists = fs::exists(there);
  if (!fs::status_known(there) || fs::is_directory(there) ||
      (exists && !may_be_written(target_))) {
    throw unwritable(target);
  }
  const bool direct = exists && !fs::is_regular_file(there);
  if (!direct) unfinished_ = unfinished_name(target_);
  stream_.open(direct ? target_ : unfinished_, std::ios::binary);
  if (stream_) return;
  unfinished_.clear();
  throw unwritable(target);
}

OutputFile::~OutputFile() {
  if (unfinished_.empty()) return;
  stream_.close();
  std::error_code gone;
  fs::remove(unfinished_, gone);
}

void OutputFile::finish() {
  if (stream_.is_open()) stream_.close();
  if (!stream_) throw unwritable(target_);
}

void OutputFile::commit() {
  finish();
  if (unfinished_.empty()) return;
  put_in_place(unfinished_, target_, rule_);
  unfinished_.clear();
}

// Beside the folder, or in it where it is there: on the same file system, so
// that files can be renamed into their place.
OutputFolder::OutputFolder(const fs::path& target, OutputRule rule)
    : target_(fs::absolute(target).lexically_normal()), rule_(std::move(rule)) {
  if (!target_.has_filename()) target_ = target_.parent_path();
  std::error_code fault;
  if (fs::is_directory(target_, fault)) {
    unfinished_ = unfinished_name(target_ / "tapfit");
  } else {
    fs::path beside = target_.parent_path();
    while (!fs::exists(beside, fault) && beside.has_relative_path()) {
      beside = beside.parent_path();
    }
    unfinished_ = unfinished_name(beside / target_.filename());
  }
  if (fs::create_directory(unfinished_, fault)) return;
  throw unwritable(target);
}

OutputFolder::~OutputFolder() {
  std::error_code gone;
  if (!unfinished_.empty()) fs::remove_all(unfinished_, gone);
}

void OutputFolder::write(
    const fs::path& name,
    const std::function<void(const fs::path&)>& writer) const {
  check_in_folder(rule_, target_, name);
  const std::string part = (unfinished_ / name).string();
  try {
    writer(part);
  } catch (const InputError& error) {
    const std::string& where = error.where();
    const std::size_t at = where.find(part);
    if (at == std::string::npos) throw;
    throw InputError(
        error.fault(),
        std::string(where).replace(at, part.size(), (target_ / name).string()),
        error.remedy());
  }
}

void OutputFolder::write(const fs::path& name, std::string_view content) const {
  write(name,
        [&](const fs::path& file) { write_file(file, content, OutputRule{}); });
}

void OutputFolder::commit() {
  std::error_code fault;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(unfinished_, fault), end; !fault && at != end;
       at.increment(fault)) {
    files.push_back(at->path());
    check_in_folder(rule_, target_, at->path().filename());
  }
  if (fault) throw unwritable(target_);
  if (!fs::exists(target_, fault)) {
    fs::create_directories(target_.parent_path(), fault);
    fs::rename(unfinished_, target_, fault);
    if (fault) throw unwritable(target_);
    unfinished_.clear();
    return;
  }
  for (const fs::path& file : files) {
    put_in_place(file, target_ / file.filename(), rule_);
  }
}

void check_in_folder(const OutputRule& rule,
                     const fs::path& folder,
                     const fs::path& name) {
  const fs::path place = folder / name;
  rule.check(place, "give another folder");
  std::error_code fault;
  const fs::file_status there = fs::status(place, fault);
  // A folder or a pipe would stop, or give way to, what is renamed onto it.
  if (fs::exists(there) &&
      (!fs::is_regular_file(there) || !may_be_written(place))) {
    throw unwritable(place);
  }
}

void write_file(const fs::path& target,
                std::string_view content,
                const OutputRule& rule) {
  OutputFile file(target, rule);
  file.stream() << content;
  file.commit();
}

void write_files(const std::vector<FileContent>& files,
                 const OutputRule& rule) {
  if (files.empty()) return;
  const fs::path folder = fs::absolute(files.front().path).parent_path();
  std::error_code fault;
  if (!fs::is_directory(folder, fault)) {
    throw InputError(
        "is no folder", folder.string(), "make it, or name another");
  }
  OutputFolder output(folder, rule);
  for (const FileContent& file : files) {
    output.write(file.path.filename(), file.content);
  }
  output.commit();
}

}  // namespace tapfit::acquisition
