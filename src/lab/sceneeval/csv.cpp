#include "csv.h"

namespace roomgen::lab {

namespace {

constexpr std::size_t most_records = 100'000, most_fields = 1000;

class CsvReader {
 public:
  CsvReader(std::string_view text, const std::string& source) : text_(text), source_(source) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
  }

  Result<std::vector<CsvRecord>> read() {
    std::vector<CsvRecord> records;
    while (at_ < text_.size()) {
      CsvRecord record;
      record.line = line_;
      bool more = true;
      while (more) {
        auto field = read_field();
        if (!field) return field.error();
        if (record.fields.size() == most_fields) return error(line_, "has more than " + std::to_string(most_fields) + " columns");
        record.fields.push_back(*std::move(field));
        more = at_ < text_.size() && text_[at_] == ',';
        if (more) ++at_;
      }
      end_line();
      if (record.fields.size() == 1 && record.fields.front().empty()) continue;
      if (records.size() == most_records)
        return error(record.line, "is beyond the " + std::to_string(most_records) + " records that are read");
      records.push_back(std::move(record));
    }
    return records;
  }

 private:
  Result<std::string> read_field() {
    if (at_ >= text_.size() || text_[at_] != '"') return read_plain();
    const int start = line_;
    std::string field;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        if (at_ + 1 >= text_.size() || text_[at_ + 1] != '"') {
          ++at_;
          if (at_ < text_.size() && text_[at_] != ',' && text_[at_] != '\n' && text_[at_] != '\r')
            return error(line_, "text after a closing quote");
          return field;
        }
        ++at_;
      }
      if (text_[at_] == '\n') ++line_;
      field += text_[at_];
    }
    return error(start, "a quote is not closed");
  }

  std::string read_plain() {
    const auto end = std::min(text_.find_first_of(",\r\n", at_), text_.size());
    std::string field(text_.substr(at_, end - at_));
    at_ = end;
    return field;
  }

  void end_line() {
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] == '\n') ++at_;
    ++line_;
  }

  Error error(int line, const std::string& what) const {
    return {Error::Kind::invalid_input, source_ + ":" + std::to_string(line) + ": " + what};
  }

  std::string_view text_;
  std::string source_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

Result<std::vector<CsvRecord>> parse_csv(std::string_view text, const std::string& source) {
  return CsvReader(text, source).read();
}

}  // namespace roomgen::lab
