#include "tests/layers/Sizes.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace fenestra::tests {
namespace {

/// The scope that a brace opens.
enum class Scope { Namespace, Type, Function, Other };

/// Reads code (codeOf) brace by brace.
class Reader {
 public:
  Reader(const SourceFile& source, std::string code) : path_(source.path), code_(std::move(code)) {}

  std::vector<Length> run() {
    for (const char c : code_) {
      if (c == '\n') ++line_;
      if (c == '{') {
        open();
      } else if (c == '}') {
        close();
      } else if ((c == ';' || (c == ':' && isAccess())) && parentheses_ == 0 && !inFunction()) {
        forget();
      } else {
        if (c == '(') ++parentheses_;
        if (c == ')') --parentheses_;
        add(c);
      }
    }
    return std::move(lengths_);
  }

 private:
  struct Open {
    Scope scope;
    std::string declaration;  ///< of a function
    int line;                 ///< where the declaration begins
  };

  bool inFunction() const {
    return std::any_of(open_.begin(), open_.end(), [](const Open& each) { return each.scope == Scope::Function; });
  }

  /// "public:" and its like stand before declarations.
  bool isAccess() const {
    return declaration_ == "public" || declaration_ == "protected" || declaration_ == "private" ||
           declaration_ == "Q_SIGNALS";
  }

  void add(char c) {
    if (declaration_.empty() && std::isspace(static_cast<unsigned char>(c))) return;
    if (declaration_.empty()) begun_ = line_;
    declaration_ += c == '\n' ? ' ' : c;
  }

  void forget() { declaration_.clear(); }

  void open() {
    const Scope scope = scopeOf();
    open_.push_back({scope, declaration_, begun_});
    // An initialiser belongs to the declaration around it, which goes on behind it.
    if (scope == Scope::Other && !inFunction())
      add('{');
    else
      forget();
  }

  void close() {
    if (open_.empty()) return;
    const Open closed = open_.back();
    open_.pop_back();
    if (closed.scope == Scope::Function && !inFunction())
      lengths_.push_back(
          {path_ + ":" + std::to_string(closed.line) + " " + nameIn(closed.declaration), line_ - closed.line + 1});
    if (closed.scope == Scope::Other && !inFunction())
      add('}');
    else
      forget();
  }

  Scope scopeOf() const {
    static const std::regex space(R"(^(inline )?(namespace|extern)\b)");
    static const std::regex type(R"(^(template ?<.*> ?)?(typedef )?(class|struct|union|enum)\b[^()]*$)");
    // Behind a parameter list: qualifiers, a returned type, a constraint, or members and their initialisers.
    static const std::regex body(
        R"(\)( (const|noexcept|override|final|mutable|try)| ?&&?|\s*->.*|\s+requires .*|\s*:[^:].*[)}])*\s*$)");
    if (inFunction() || parentheses_ > 0) return Scope::Other;
    if (std::regex_search(declaration_, space)) return Scope::Namespace;
    if (std::regex_search(declaration_, type)) return Scope::Type;
    return std::regex_search(declaration_, body) ? Scope::Function : Scope::Other;
  }

  /// The text before the parameter list.
  static std::string nameIn(const std::string& declaration) {
    std::string before = declaration.substr(0, declaration.find('('));
    before.erase(0, before.rfind(' ') + 1);
    return before;
  }

  std::string path_, code_;
  int line_ = 1, begun_ = 1, parentheses_ = 0;
  std::string declaration_;  ///< since the last one ended
  std::vector<Open> open_;
  std::vector<Length> lengths_;
};

}  // namespace

std::vector<Length> functionLengths(const SourceFile& source) { return Reader(source, codeOf(source.text)).run(); }

int lineCount(const SourceFile& source) {
  return static_cast<int>(std::count(source.text.begin(), source.text.end(), '\n'));
}

}  // namespace fenestra::tests
