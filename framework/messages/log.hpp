#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "framework/files/file_writer.hpp"

namespace dda {

/// `log.jsonl`: what happened in a run, one JSON object per line, each flushed.
///
///     {"time": "2024-05-01T12:00:00.123Z", "level": "info", "event": "step", ...fields}
///
/// A default-constructed log discards everything.
class Log {
 public:
  using Fields = nlohmann::ordered_json;

  Log() = default;
  explicit Log(const std::filesystem::path& path, FileWriter::Mode mode = FileWriter::Mode::create);

  /// `fields` is an object; its keys stand behind time, level and event and do not replace them.
  void info(std::string_view event, const Fields& fields = Fields::object());
  void warning(std::string_view event, const Fields& fields = Fields::object());
  void error(std::string_view event, const Fields& fields = Fields::object());

 private:
  void write(std::string_view level, std::string_view event, const Fields& fields);
  std::optional<FileWriter> file_;
};

}  // namespace dda
