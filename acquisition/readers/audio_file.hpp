// The room acquisition/readers. Files that others wrote, as matrices of
// numbers: sound files, CSV, MATLAB.
// In:  A path.
// Out: Numbers and what the file says of them, or an InputError with the place
//      in the file. What they mean is decided further on.
// May include: its row in CONTRIBUTING.md.
//
// Sound files as matrices, by way of libsndfile (included only here).
#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <memory>
#include <string>

namespace tapfit::acquisition {

struct Audio {
  double sample_rate_hz = 0.0;
  Eigen::MatrixXd
      samples;  ///< n_samples x n_channels, 1.0 = digital full scale
};

/// Reads a whole file of any format that libsndfile knows (WAV, W64, RF64,
/// FLAC, AIFF, CAF, ...).
///
/// @throws InputError for a file that is missing, no sound file, empty, or
///   shorter than its header says
[[nodiscard]] Audio read_audio(const std::filesystem::path& file);

/// A sound file read piece by piece, for files larger than memory.
class AudioReader {
 public:
  /// @throws InputError as read_audio
  explicit AudioReader(const std::filesystem::path& file);
  ~AudioReader();
  AudioReader(AudioReader&&) noexcept;
  AudioReader& operator=(AudioReader&&) noexcept;

  [[nodiscard]] double sample_rate_hz() const;
  [[nodiscard]] Eigen::Index samples() const;
  [[nodiscard]] Eigen::Index channels() const;
  /// Whether samples may be infinite or no numbers, as integers never are.
  [[nodiscard]] bool floating_point() const;

  /// The next samples, as many as `out` has rows.
  ///
  /// @param out rows x channels()
  /// @param scale channels(), value of digital full scale
  /// @return rows that were filled; fewer only at the file's end
  /// @throws InputError for a file that ends before its announced length
  Eigen::Index read(Eigen::Ref<Eigen::MatrixXd> out,
                    const Eigen::RowVectorXd& scale);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The name of an encoding that does not keep the samples as they were, such as
/// "Microsoft ADPCM" or "Vorbis"; empty for one that does, and for what is no
/// sound file.
[[nodiscard]] std::string lossy_encoding(const std::filesystem::path& file);

/// Room for all samples of a file, not yet filled.
/// @throws InputError where memory does not hold them
[[nodiscard]] Eigen::MatrixXd room_for(Eigen::Index samples,
                                       Eigen::Index channels,
                                       const std::filesystem::path& file);

/// The version of libsndfile that is in use.
[[nodiscard]] std::string sound_library();

enum class AudioFormat { Flac24, Wav24, WavFloat64 };

/// Writes n_samples x n_channels, 1.0 = digital full scale. The integer formats
/// round to 24 bits and clip what lies beyond full scale; WavFloat64 keeps
/// every value as it is.
///
/// @param rate sampling rate [Hz], a whole number
/// @throws InputError when the file cannot be written, or FLAC is asked for
///   more than 8 channels
void write_audio(const std::filesystem::path& file,
                 const Eigen::MatrixXd& samples,
                 int rate,
                 AudioFormat format);

}  // namespace tapfit::acquisition
