#include "framework/files/claims.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "framework/base/errors.hpp"
#include "framework/files/file_writer.hpp"
#include "framework/files/whole_file.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view beats_key = "{\"beats\": ";  // what every file begins with
constexpr std::size_t beats_width = 20;                 // digits of the largest number of 64 bits

/// Numbers that change have a fixed width, so that the line is rewritten in place.
std::string head_of(const Claim& claim) {
  return fmt::format(
      "{}{:>{}}, \"pid\": {:>{}}, \"start\": {:>{}}, \"host\": {}, \"machine\": {}, \"lease\": {}, \"note\": "
      "{}}}\n",
      beats_key, claim.beats, beats_width, claim.owner.number, beats_width, claim.owner.start, beats_width,
      Json(claim.owner.host).dump(), Json(claim.owner.machine).dump(), claim.lease, claim.note.dump());
}

/// Null unless it is a whole line that holds an object.
Json line_at(const std::string& text, std::size_t begin) {
  const auto end = text.find('\n', begin);
  if (end == std::string::npos) return {};
  Json out = Json::parse(text.substr(begin, end - begin), nullptr, false);
  return out.is_object() ? out : Json();
}

/// Members that are not there, or of another kind, keep their values: a file may be half written.
template <class T>
void take_over(const Json& from, const char* key, T& to) {
  if (const auto found = from.find(key); found != from.end()) {
    try {
      to = found->get<T>();
    } catch (const Json::exception&) {
    }
  }
}

void read_into(Claim& claim, const fs::path& file) {
  const std::string text = read_whole(file);
  const Json head = line_at(text, 0);
  if (!head.is_object()) return;
  take_over(head, "beats", claim.beats);
  take_over(head, "pid", claim.owner.number);
  take_over(head, "start", claim.owner.start);
  take_over(head, "host", claim.owner.host);
  take_over(head, "machine", claim.owner.machine);
  take_over(head, "lease", claim.lease);
  claim.note = head.value("note", Json());
  claim.outcome = line_at(text, text.find('\n') + 1);
}

/// NAME.g; generation 0 for a file that is no claim.
Claim named(const std::string& file) {
  Claim out;
  const auto dot = file.rfind('.');
  if (dot == std::string::npos || dot == 0) return out;
  out.name = file.substr(0, dot);
  const char* const end = file.data() + file.size();
  const auto [rest, error] = std::from_chars(file.data() + dot + 1, end, out.generation);
  if (error != std::errc() || rest != end) out.generation = 0;
  return out;
}

[[noreturn]] void fail(const fs::path& file, int reason) {
  throw OutputError(fmt::format("cannot write '{}': {}", file.string(), std::strerror(reason)));
}

/// Whether it was not there before.
bool create_exclusively(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (descriptor < 0 && errno == EEXIST) return false;
  if (descriptor < 0 && errno == ENOENT)
    throw OutputError(fmt::format("'{}' is gone: another process has begun anew there; start this one again",
                                  file.parent_path().string()));
  if (descriptor < 0) fail(file, errno);
  ::close(descriptor);
  return true;
}

}  // namespace

bool beat(const ClaimFiles& files, std::uint64_t beats) noexcept {
  if (::access(files.next.c_str(), F_OK) == 0) return false;
  const int descriptor = ::open(files.own.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return true;  // it may be there again at the next beat
  std::array<char, beats_width> digits{};
  digits.fill(' ');
  for (std::size_t i = beats_width; i-- > 0 && beats > 0; beats /= 10)
    digits[i] = static_cast<char>('0' + beats % 10);
  [[maybe_unused]] const ssize_t written =
      ::pwrite(descriptor, digits.data(), digits.size(), static_cast<off_t>(beats_key.size()));
  ::close(descriptor);
  return true;
}

ClaimFiles Claims::files_of(const Claim& claim) const {
  return {folder_ / fmt::format("{}.{}", claim.name, claim.generation),
          folder_ / fmt::format("{}.{}", claim.name, claim.generation + 1)};
}

const std::map<std::string, Claim>& Claims::look() {
  std::map<std::string, Claim> newest;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    Claim found = named(entry.path().filename().string());
    if (found.generation == 0) continue;
    Claim& known = newest[found.name];
    if (found.generation > known.generation) known = std::move(found);
  }
  for (auto& [name, claim] : newest) {
    const auto before = claims_.find(name);
    if (before != claims_.end() && before->second.generation == claim.generation &&
        before->second.holder == Holder::ended) {
      claim = before->second;
      continue;
    }
    claim.lease = lease_;
    read_into(claim, files_of(claim).own);
    claim.holder = judge(claim);
  }
  claims_ = std::move(newest);
  return claims_;
}

Holder Claims::judge(const Claim& claim) {
  if (claim.outcome.is_object()) return Holder::ended;
  if (is_of_this_machine(claim.owner)) return is_alive(claim.owner) ? Holder::alive : Holder::dead;
  Sign& sign = signs_[claim.name];
  const auto now = Clock::now();
  const bool is_known = sign.generation == claim.generation;
  if (!is_known || sign.beats != claim.beats) sign = {claim.generation, claim.beats, now, is_known};
  if (std::chrono::duration<double>(now - sign.since).count() > claim.lease) return Holder::dead;
  return sign.has_beaten ? Holder::alive : Holder::silent;
}

std::optional<Claim> Claims::take(const std::string& name, const Json& note) {
  const auto last = claims_.find(name);
  if (last != claims_.end() && last->second.is_held()) return {};
  Claim out;
  out.name = name;
  out.generation = last == claims_.end() ? 1 : last->second.generation + 1;
  out.owner = id_of(getpid());
  out.beats = 1;
  out.lease = lease_;
  out.note = note;
  out.holder = Holder::alive;
  const fs::path file = files_of(out).own;
  if (!create_exclusively(file)) return {};
  try {
    FileWriter(file, FileWriter::Mode::append).write(head_of(out));
  } catch (const OutputError&) {
    std::error_code ignored;
    fs::remove(file, ignored);
    throw;
  }
  claims_[name] = out;
  return out;
}

void Claims::hand_over(Claim& claim, pid_t process) const {
  claim.owner = id_of(process);
  const fs::path file = files_of(claim).own;
  const std::string head = head_of(claim);
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(file, errno);
  const bool is_written =
      ::pwrite(descriptor, head.data(), head.size(), 0) == static_cast<ssize_t>(head.size());
  const int reason = errno;
  ::close(descriptor);
  if (!is_written) fail(file, reason);
}

void Claims::end(Claim& claim, const Json& outcome) const {
  FileWriter(files_of(claim).own, FileWriter::Mode::append)
      .write(outcome.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  claim.outcome = outcome;
  claim.holder = Holder::ended;
}

}  // namespace dda
