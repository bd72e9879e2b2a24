#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "roomgen/base/cancel.h"
#include "roomgen/base/json.h"
#include "roomgen/base/result.h"

namespace roomgen::mcp {

/// Tells how far the work is: of `total`, `done`, and in words.
using Progress = std::function<void(double done, double total, const std::string& what)>;

/// A call of a tool. Its arguments keep to the tool's schema.
struct ToolCall {
  Json arguments = Json::object();
  CancelToken cancel = {};
  /// Tells who waits; does nothing unless somebody asked to be told. What is not further than before
  /// is not sent.
  Progress progress = [](auto&&...) {};
};

/// What a tool answers: texts and pictures for the model that asked, and the same as data.
struct ToolAnswer {
  Json content = Json::array();
  Json data = nullptr;
};

ToolAnswer text_answer(const std::string& text, Json data = nullptr);
/// A picture of these PNG or JPEG bytes after what the answer says already.
void add_picture(ToolAnswer& answer, const std::string& picture);

/// An error becomes an answer that says so, for the model to read.
using Tool = std::function<Result<ToolAnswer>(const ToolCall&)>;

/// What a server offers. `about` is data/mcp/tools.json, the functions are by the names there.
struct Offer {
  Json about;
  std::string version;
  std::map<std::string, Tool> tools;
  std::function<Json()> list_resources;
  /// not_found for an address that is none.
  std::function<Result<std::string>(const std::string& uri)> read_resource;
};

}  // namespace roomgen::mcp
