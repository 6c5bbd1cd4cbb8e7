#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "framework/base/vec2.hpp"
#include "framework/files/run/restart_file.hpp"

namespace dda {

/// Writes a struct into restart data, member by member; `RecordReader` reads it back.
///
/// The struct declares its members once, as pairs of name and reference:
///
///     template <class Self, class Visit>
///     static void visit(Self& self, Visit& visit) {
///       visit("step", self.step);
///       visit("load", self.load);
///     }
///
/// Numbers, flags and points are kept together in one array under the record's name, beside the list of
/// their names; texts and arrays under "record.member".
class RecordWriter {
 public:
  RecordWriter(RestartData& data, std::string name);

  void operator()(const char* member, double value);
  void operator()(const char* member, int value) { (*this)(member, static_cast<double>(value)); }
  void operator()(const char* member, long long value) { (*this)(member, static_cast<double>(value)); }
  void operator()(const char* member, bool value) { (*this)(member, value ? 1.0 : 0.0); }
  /// NaN where there is none.
  template <class Number>
  void operator()(const char* member, const std::optional<Number>& value) {
    (*this)(member, value ? double(*value) : std::numeric_limits<double>::quiet_NaN());
  }
  void operator()(const char* member, const Vec2& value);
  template <std::size_t size>
  void operator()(const char* member, const std::array<double, size>& values) {
    for (const double value : values) (*this)(member, value);
  }
  void operator()(const char* member, const std::string& value);
  void operator()(const char* member, const std::vector<double>& value);
  void operator()(const char* member, const std::vector<Vec2>& value);
  /// Arrays of one length.
  void operator()(const char* member, const std::vector<std::vector<double>>& values);

  /// What follows is the next of many records, whose members have their names by now.
  void begin_next() { names_ = nullptr; }

 private:
  RestartData& data_;
  std::string name_;
  std::vector<double>& numbers_;
  std::vector<std::string>* names_;  ///< of the members of the first record
};

/// Reads what `RecordWriter` has written, bit for bit. Throws std::runtime_error where the file has other
/// members.
class RecordReader {
 public:
  RecordReader(const RestartData& data, std::string name);

  void operator()(const char* member, double& value) { value = next(member); }
  void operator()(const char* member, int& value) { value = static_cast<int>(next(member)); }
  void operator()(const char* member, long long& value) { value = static_cast<long long>(next(member)); }
  void operator()(const char* member, bool& value) { value = next(member) != 0; }
  template <class Number>
  void operator()(const char* member, std::optional<Number>& value) {
    const double number = next(member);
    value = std::isnan(number) ? std::nullopt : std::optional(static_cast<Number>(number));
  }
  void operator()(const char* member, Vec2& value);
  template <std::size_t size>
  void operator()(const char* member, std::array<double, size>& values) {
    for (double& value : values) value = next(member);
  }
  void operator()(const char* member, std::string& value);
  void operator()(const char* member, std::vector<double>& value);
  void operator()(const char* member, std::vector<Vec2>& value);
  void operator()(const char* member, std::vector<std::vector<double>>& values);

 private:
  double next(const char* member);
  template <class Values>
  const Values& array(const std::map<std::string, Values>& arrays, const std::string& suffix) const;

  const RestartData& data_;
  std::string name_;
  const std::vector<double>& numbers_;
  const std::vector<std::string>& names_;
  std::size_t at_ = 0;  ///< numbers read so far
};

template <class Record>
void put(RestartData& data, const std::string& name, const Record& record) {
  RecordWriter out(data, name);
  Record::visit(record, out);
}

template <class Record>
Record take(const RestartData& data, const std::string& name) {
  Record out;
  RecordReader in(data, name);
  Record::visit(out, in);
  return out;
}

/// Many records of numbers alone, one after another.
template <class Record>
void put_all(RestartData& data, const std::string& name, const std::vector<Record>& records) {
  RecordWriter out(data, name);
  for (const Record& record : records) {
    Record::visit(record, out);
    out.begin_next();
  }
}

template <class Record>
std::vector<Record> take_all(const RestartData& data, const std::string& name) {
  const auto width = data.texts.at(name + ".members").size();
  std::vector<Record> out(width == 0 ? 0 : data.numbers.at(name).size() / width);
  RecordReader in(data, name);
  for (Record& record : out) Record::visit(record, in);
  return out;
}

}  // namespace dda
