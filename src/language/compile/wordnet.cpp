#include "wordnet.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

namespace roomgen::language {

namespace {

namespace fs = std::filesystem;
using Offsets = std::unordered_map<std::string, std::uint32_t>;  // "n 00001740" -> synset

constexpr std::array<const char*, WordNet::parts> names = {"noun", "verb", "adj", "adv"};
constexpr std::string_view letters = "nvar";

std::ifstream open(const fs::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return stream;
}

// "dining_table" is two words; "galore(ip)" says where the adjective may stand.
std::string plain(std::string word) {
  word = word.substr(0, word.find('('));
  for (char& c : word) {
    if (c == '_') c = ' ';
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return word;
}

// The head of an adjective satellite is marked s and numbered with the adjectives.
char letter_of(const std::string& part) {
  return part == "s" ? 'a' : part.at(0);
}

struct Pointer {
  std::string symbol, target;
};

struct Record {
  Synset synset;
  std::vector<Pointer> pointers;
};

Record parse_record(const std::string& line) {
  std::istringstream in(line.substr(0, line.find('|')));
  std::string offset, file, part, word, lex_id;
  std::size_t words = 0, pointers = 0;
  in >> offset >> file >> part >> std::hex >> words >> std::dec;
  Record record;
  for (; words > 0 && in >> word >> lex_id; --words) record.synset.members.push_back(plain(word));
  for (in >> pointers; pointers > 0; --pointers) {
    std::string symbol, target, kind, ends;
    if (!(in >> symbol >> target >> kind >> ends))
      throw std::runtime_error("no WordNet record: " + line.substr(0, 60));
    record.pointers.push_back({symbol, std::string(1, letter_of(kind)) + target});
  }
  return record;
}

// What leads to something more general. An adjective leads to the one it is like, and to the noun
// that it is made from or says something of.
bool generalises(const Pointer& pointer, char from) {
  const char to = pointer.target[0];
  if (pointer.symbol == "@" || pointer.symbol == "@i") return true;
  if (from != 'a') return false;
  return pointer.symbol == "\\" || pointer.symbol == "=" || (pointer.symbol == "+" && to == 'n');
}

class Reader {
 public:
  explicit Reader(fs::path folder) : folder_(std::move(folder)) {}

  WordNet run() {
    for (std::size_t part = 0; part < WordNet::parts; ++part) read_synsets(part);
    connect();
    read_counts();
    for (std::size_t part = 0; part < WordNet::parts; ++part) read_lemmas(part);
    for (std::size_t part = 0; part < WordNet::parts; ++part) read_irregular(part);
    return std::move(result_);
  }

 private:
  void read_synsets(std::size_t part) {
    result_.first[part] = static_cast<std::uint32_t>(result_.synsets.size());
    auto stream = open(folder_ / (std::string("data.") + names[part]));
    for (std::string line; std::getline(stream, line);) {
      if (line.starts_with("  ")) {
        if (part == 0) add_licence(line);
        continue;
      }
      auto record = parse_record(line);
      const auto id = static_cast<std::uint32_t>(result_.synsets.size());
      offsets_[letters[part] + line.substr(0, 8)] = id;
      result_.synsets.push_back(std::move(record.synset));
      satellites_.push_back(line.substr(12, 1) == "s");
      pointers_.push_back(std::move(record.pointers));
    }
    result_.first[part + 1] = static_cast<std::uint32_t>(result_.synsets.size());
  }

  // "  12 text  "
  void add_licence(const std::string& line) {
    const auto text = line.find_first_not_of(" 0123456789");
    if (text != std::string::npos)
      result_.licence += line.substr(text, line.find_last_not_of(' ') + 1 - text);
    result_.licence += '\n';
  }

  void connect() {
    for (std::uint32_t id = 0; id < pointers_.size(); ++id) {
      std::size_t part = 0;
      while (id >= result_.first[part + 1]) ++part;
      for (const auto& pointer : pointers_[id]) {
        const bool head = satellites_[id] && pointer.symbol == "&";
        if (!head && !generalises(pointer, letters[part])) continue;
        auto& general = result_.synsets[id].general;
        const std::uint32_t target = offsets_.at(pointer.target);
        if (general.empty() || general.back() != target) general.push_back(target);
      }
    }
  }

  // "abandon%2:40:00:: 1 10": lemma, type of synset, ...; sense, times.
  void read_counts() {
    auto stream = open(folder_ / "cntlist.rev");
    std::string key;
    for (std::uint32_t sense = 0, times = 0; stream >> key >> sense >> times;) {
      const auto percent = key.find('%');
      const int type = key.at(percent + 1) - '1';
      const char letter = letters[type == 4 ? 2 : type];
      counts_[letter + plain(key.substr(0, percent)) + ' ' + std::to_string(sense)] = times;
    }
  }

  void read_lemmas(std::size_t part) {
    auto stream = open(folder_ / (std::string("index.") + names[part]));
    for (std::string line; std::getline(stream, line);) {
      if (line.starts_with("  ")) continue;
      std::istringstream in(line);
      std::string lemma, letter, skipped, offset;
      std::size_t senses = 0, pointers = 0;
      in >> lemma >> letter >> senses >> pointers;
      for (pointers += 2; pointers > 0; --pointers) in >> skipped;
      lemma = plain(lemma);
      auto& list = result_.lemmas[lemma][part];
      for (std::size_t rank = 1; rank <= senses && in >> offset; ++rank) {
        const auto found = counts_.find(letters[part] + lemma + ' ' + std::to_string(rank));
        list.push_back(
            {offsets_.at(letters[part] + offset), found == counts_.end() ? 0 : found->second});
      }
    }
  }

  void read_irregular(std::size_t part) {
    auto stream = open(folder_ / (std::string(names[part]) + ".exc"));
    for (std::string line; std::getline(stream, line);) {
      std::istringstream in(line);
      std::string form, lemma;
      in >> form;
      while (in >> lemma)
        if (result_.lemmas.count(plain(lemma)) && plain(form) != plain(lemma))
          result_.irregular.push_back({plain(form), {plain(lemma), static_cast<int>(part)}});
    }
  }

  fs::path folder_;
  WordNet result_;
  Offsets offsets_, counts_;
  std::vector<bool> satellites_;
  std::vector<std::vector<Pointer>> pointers_;
};

}  // namespace

WordNet read_wordnet(const fs::path& folder) {
  return Reader(folder).run();
}

}  // namespace roomgen::language
