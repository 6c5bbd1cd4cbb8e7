#include "framework/files/run/record.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace dda {

RecordWriter::RecordWriter(RestartData& data, std::string name)
    : data_(data),
      name_(std::move(name)),
      numbers_(data.numbers[name_] = {}),
      names_(&(data.texts[name_ + ".members"] = {})) {}

void RecordWriter::operator()(const char* member, double value) {
  numbers_.push_back(value);
  if (names_) names_->emplace_back(member);
}

void RecordWriter::operator()(const char* member, const Vec2& value) {
  (*this)(member, value.x());
  (*this)(member, value.y());
}

void RecordWriter::operator()(const char* member, const std::string& value) {
  data_.texts[name_ + "." + member] = {value};
}

void RecordWriter::operator()(const char* member, const std::vector<double>& value) {
  data_.numbers[name_ + "." + member] = value;
}

void RecordWriter::operator()(const char* member, const std::vector<Vec2>& value) {
  std::vector<double>& flat = data_.numbers[name_ + "." + member] = {};
  for (const Vec2& v : value) flat.insert(flat.end(), {v.x(), v.y()});
}

void RecordWriter::operator()(const char* member, const std::vector<std::vector<double>>& values) {
  (*this)(member, static_cast<double>(values.size()));
  std::vector<double>& flat = data_.numbers[name_ + "." + member] = {};
  for (const auto& array : values) flat.insert(flat.end(), array.begin(), array.end());
}

RecordReader::RecordReader(const RestartData& data, std::string name)
    : data_(data),
      name_(std::move(name)),
      numbers_(array(data.numbers, "")),
      names_(array(data.texts, ".members")) {}

double RecordReader::next(const char* member) {
  const bool is_named = at_ >= names_.size() || names_[at_] == member;  // all records are alike
  if (names_.empty() || at_ >= numbers_.size() || !is_named)
    throw std::runtime_error(fmt::format("the record '{}' has no '{}' at its place", name_, member));
  return numbers_[at_++];
}

template <class Values>
const Values& RecordReader::array(const std::map<std::string, Values>& arrays,
                                  const std::string& suffix) const {
  const auto found = arrays.find(name_ + suffix);
  if (found == arrays.end()) throw std::runtime_error(fmt::format("there is no '{}{}'", name_, suffix));
  return found->second;
}

void RecordReader::operator()(const char* member, Vec2& value) {
  value.x() = next(member);
  value.y() = next(member);
}

void RecordReader::operator()(const char* member, std::string& value) {
  const auto& texts = array(data_.texts, std::string(".") + member);
  if (texts.size() != 1) throw std::runtime_error(fmt::format("'{}.{}' is no text", name_, member));
  value = texts.front();
}

void RecordReader::operator()(const char* member, std::vector<double>& value) {
  value = array(data_.numbers, std::string(".") + member);
}

void RecordReader::operator()(const char* member, std::vector<Vec2>& value) {
  const auto& flat = array(data_.numbers, std::string(".") + member);
  value.clear();
  for (std::size_t i = 0; i + 1 < flat.size(); i += 2) value.emplace_back(flat[i], flat[i + 1]);
}

void RecordReader::operator()(const char* member, std::vector<std::vector<double>>& values) {
  values.resize(static_cast<std::size_t>(next(member)));
  const auto& flat = array(data_.numbers, std::string(".") + member);
  auto at = flat.begin();
  for (auto& one : values) {
    const auto end = at + std::ssize(flat) / std::ssize(values);
    one.assign(at, end);
    at = end;
  }
}

}  // namespace dda
