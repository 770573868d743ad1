#include "acquisition/instruments/usual_names.hpp"

#include <array>
#include <cctype>

namespace tapfit::acquisition {
namespace {

struct Spelling {
  std::string_view text;
  UsualName is;
};

constexpr auto usual_spellings = std::to_array<Spelling>({
    {"fs", UsualName::Rate},
    {"fshz", UsualName::Rate},
    {"fsamp", UsualName::Rate},
    {"rate", UsualName::Rate},
    {"ratehz", UsualName::Rate},
    {"samplerate", UsualName::Rate},
    {"sampleratehz", UsualName::Rate},
    {"samplingrate", UsualName::Rate},
    {"samplingratehz", UsualName::Rate},
    {"samplefrequency", UsualName::Rate},
    {"samplefreq", UsualName::Rate},
    {"samplingfrequency", UsualName::Rate},
    {"samplingfreq", UsualName::Rate},
    {"sampfreq", UsualName::Rate},
    {"srate", UsualName::Rate},
    {"sr", UsualName::Rate},
    {"samplespersecond", UsualName::Rate},
    {"dt", UsualName::Step},
    {"deltat", UsualName::Step},
    {"tstep", UsualName::Step},
    {"timestep", UsualName::Step},
    {"increment", UsualName::Step},
    {"xincrement", UsualName::Step},
    {"wfincrement", UsualName::Step},
    {"samplinginterval", UsualName::Step},
    {"sampleinterval", UsualName::Step},
    {"samplingperiod", UsualName::Step},
    {"sampleperiod", UsualName::Step},
    {"t", UsualName::Time},
    {"time", UsualName::Time},
    {"times", UsualName::Time},
    {"timesec", UsualName::Time},
    {"seconds", UsualName::Time},
    {"timevector", UsualName::Time},
    {"timeaxis", UsualName::Time},
    {"abscissa", UsualName::Time},
    {"name", UsualName::Names},
    {"names", UsualName::Names},
    {"channel", UsualName::Names},
    {"channels", UsualName::Names},
    {"channelname", UsualName::Names},
    {"channelnames", UsualName::Names},
    {"nichannelname", UsualName::Names},
    {"label", UsualName::Names},
    {"labels", UsualName::Names},
    {"longname", UsualName::Names},
    {"unit", UsualName::Units},
    {"units", UsualName::Units},
    {"unitstr", UsualName::Units},
    {"unitstring", UsualName::Units},
    {"channelunits", UsualName::Units},
});

constexpr std::string_view separators = "./@";

// Letters and digits alone: "Time [s]" is "times".
std::string plain_letters(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0) {
      plain += static_cast<char>(std::tolower(letter));
    }
  }
  return plain;
}

}  // namespace

std::string_view last_part(std::string_view name) {
  const std::size_t at = name.find_last_of(separators);
  return at == std::string_view::npos ? name : name.substr(at + 1);
}

UsualName usual_name(std::string_view name) {
  const std::string plain = plain_letters(last_part(name));
  for (const Spelling& spelling : usual_spellings) {
    if (spelling.text == plain) return spelling.is;
  }
  return UsualName::None;
}

}  // namespace tapfit::acquisition
