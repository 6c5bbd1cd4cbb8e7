#include "framework/messages/log.hpp"

#include "framework/messages/provenance.hpp"

namespace dda {

Log::Log(const std::filesystem::path& path, FileWriter::Mode mode) : file_(FileWriter(path, mode)) {}

void Log::info(std::string_view event, const Fields& fields) { write("info", event, fields); }
void Log::warning(std::string_view event, const Fields& fields) { write("warning", event, fields); }
void Log::error(std::string_view event, const Fields& fields) { write("error", event, fields); }

void Log::write(std::string_view level, std::string_view event, const Fields& fields) {
  if (!file_) return;
  Fields line = {{"time", utc_now()}, {"level", level}, {"event", event}};
  for (const auto& [key, value] : fields.items()) {
    if (!line.contains(key)) line[key] = value;
  }
  // Replacing invalid UTF-8 keeps a strange file name from ending a run.
  file_->write(line.dump(-1, ' ', false, Fields::error_handler_t::replace) + '\n');
}

}  // namespace dda
