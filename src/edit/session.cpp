#include "roomgen/edit/session.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "edit_scene.h"
#include "hand_edits.h"
#include "history.h"
#include "roomgen/base/json.h"
#include "roomgen/base/text.h"
#include "roomgen/evaluate/report.h"

namespace roomgen {

namespace {

Json operations_json(std::span<const edit::Operation> operations) {
  Json json = Json::array();
  for (const auto& operation : operations) json.push_back(edit::to_json(operation));
  return json;
}

Result<Scene> scene_of(const SceneState& state) {
  return scene_from_json(state.document, "state " + std::to_string(state.sequence));
}

}  // namespace

struct Session::Impl {
  Impl(History the_history, Scene the_scene, const AssetLibrary& library, const KindTable& kinds,
       SessionOptions the_options)
      : history(std::move(the_history)), scene(std::move(the_scene)), options(std::move(the_options)),
        shop(library, kinds, options.spare_models, options.log) {}

  // After the history went to another state.
  Status follow() {
    auto now = scene_of(history.state());
    if (!now) return now.error();
    scene = *std::move(now);
    return {};
  }

  Result<Scene> scene_at(std::size_t state) const {
    const auto found = history.state(state);
    if (!found) return found.error();
    return scene_of(*found);
  }

  // Before the last edit; nothing if there was none.
  std::optional<Scene> earlier() const {
    const auto before = history.timeline().before(history.state().sequence);
    if (!before) return std::nullopt;
    auto scene_then = scene_at(*before);
    if (!scene_then) return std::nullopt;
    return *std::move(scene_then);
  }

  // The things that the last edit named; neighbours that made way for them are none.
  std::set<std::string> named_by_last() const {
    std::set<std::string> ids;
    const auto entry = history.timeline().entries().find(history.state().sequence);
    if (entry == history.timeline().entries().end()) return ids;
    const auto operations = parse_json(entry->second.operations, "operations");
    if (!operations || !operations->is_array()) return ids;
    const auto add = [&](const Json& id) {
      if (id.is_string()) ids.insert(id.get<std::string>());
    };
    for (const auto& operation : *operations) {
      for (const char* key : {"object", "first", "second"})
        if (operation.contains(key)) add(operation[key]);
      if (operation.contains("objects"))
        for (const auto& id : operation["objects"]) add(id);
    }
    return ids;
  }

  // What the scene would be; nothing is changed.
  auto edited(std::span<const edit::Operation> operations) {
    shop.fetch_models(scene);
    const bool may_revert = std::any_of(
        operations.begin(), operations.end(),
        [](const edit::Operation& one) { return std::holds_alternative<edit::Revert>(one); });
    const auto before = may_revert ? earlier() : std::nullopt;
    return edit_scene(shop, scene, before ? &*before : nullptr, operations, options);
  }

  Recall recall() const {
    Recall recall;
    const auto before = earlier();
    if (!before) return recall;
    const auto named = named_by_last();
    for (const auto& object : scene.objects) {
      const Object* old = find_object(*before, object.id);
      if (!old) recall.added.push_back(object.id);
      const bool is_other =
          old && (old->position != object.position || old->relations != object.relations || old->yaw != object.yaw ||
                  old->size != object.size || old->asset != object.asset || old->locked != object.locked);
      if (is_other && (named.empty() || named.count(object.id))) recall.touched.push_back(object.id);
    }
    return recall;
  }

  History history;
  Scene scene;
  SessionOptions options;
  Workshop shop;
};

Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

namespace {

// Of a scene that no edit made: what is wrong with it, before it is changed.
void tell_faults(const Scene& scene, const ModelTable& models, const KindTable& kinds, History& history) {
  constexpr std::size_t most_told = 8;
  const auto violations = examine(scene, models, kinds).violations;
  for (std::size_t i = 0; i < std::min(violations.size(), most_told); ++i)
    history.add_notice("the scene breaks a rule: " + to_text(violations[i]));
  if (violations.size() > most_told)
    history.add_notice("and " + std::to_string(violations.size() - most_told) + " more; check names them all");
}

}  // namespace

Result<Session> Session::open(const std::filesystem::path& scene_file, const AssetLibrary& library,
                              const KindTable& kinds, SessionOptions options) {
  const SceneAccess access = options.look_only ? SceneAccess::look : SceneAccess::edit;
  auto files = open_scene_files(scene_file, access);
  if (!files) return files.error();
  auto history = History::open(*std::move(files), access);
  if (!history) return history.error();
  auto scene = scene_of(history->state());
  if (!scene) return scene.error();
  auto impl = std::make_unique<Impl>(*std::move(history), *std::move(scene), library, kinds, std::move(options));
  if (impl->history.is_taken_from_file()) {
    impl->shop.fetch_models(impl->scene);
    tell_faults(impl->scene, impl->shop.models(), kinds, impl->history);
  }
  return Session(std::move(impl));
}

const Scene& Session::scene() const { return impl_->scene; }
const KindTable& Session::kinds() const { return impl_->shop.kinds(); }
Recall Session::recall() const { return impl_->recall(); }
const std::string& Session::text() const { return impl_->history.state().text; }
const std::vector<std::string>& Session::notices() const { return impl_->history.notices(); }
bool Session::is_saved() const { return impl_->history.is_saved(); }
Status Session::save() { return impl_->history.save(); }
void Session::mark_saved() { impl_->history.mark_saved(); }

const ModelTable& Session::models() {
  impl_->shop.fetch_models(impl_->scene);
  return impl_->shop.models();
}

Status Session::rehearse(std::span<const edit::Operation> operations) {
  const auto edited = impl_->edited(operations);
  return edited ? Status() : Status(edited.error());
}

Result<HandEdits> Session::compare(std::span<const SceneNode> nodes) {
  impl_->shop.fetch_models(impl_->scene);
  return read_hand_edits(impl_->scene, impl_->shop.models(), nodes);
}

Result<EditReport> Session::apply(std::span<const edit::Operation> operations, const Asker& asker) {
  if (operations.empty()) return Error{Error::Kind::invalid_input, "there is nothing to do"};
  auto edited = impl_->edited(operations);
  if (!edited) return edited.error();
  const Deed deed{asker.asked, asker.by, operations_json(operations)};
  if (auto status = impl_->history.commit(edited->scene, deed); !status) return status.error();
  // As it will be read again: numbers are rounded in files.
  if (auto status = impl_->follow(); !status) return status.error();
  edited->report.state = impl_->history.state().sequence;
  return std::move(edited->report);
}

Result<Preview> Session::preview(std::string_view object, const WantedPose& pose) {
  impl_->shop.fetch_models(impl_->scene);
  return preview_pose(impl_->shop, impl_->scene, object, pose);
}

Result<std::size_t> Session::undo(std::size_t steps, const std::string& by) {
  auto taken = impl_->history.undo(steps, by);
  if (taken && *taken > 0)
    if (auto status = impl_->follow(); !status) return status.error();
  return taken;
}

Result<std::size_t> Session::redo(std::size_t steps, const std::string& by) {
  auto taken = impl_->history.redo(steps, by);
  if (taken && *taken > 0)
    if (auto status = impl_->follow(); !status) return status.error();
  return taken;
}

Status Session::branch(const std::string& name, std::optional<std::size_t> at, const std::string& by) {
  if (auto status = impl_->history.branch(name, at, by); !status) return status;
  return impl_->follow();
}

const std::string& Session::current_branch() const { return impl_->history.timeline().branch(); }

std::vector<std::string> Session::branches() const {
  std::vector<std::string> names;
  for (const auto& [name, branch] : impl_->history.timeline().branches()) names.push_back(name);
  return names;
}

std::vector<HistoryItem> Session::history() const {
  const Timeline& timeline = impl_->history.timeline();
  std::set<std::size_t> on_the_way;
  for (std::optional<std::size_t> at = timeline.head(); at; at = timeline.before(*at)) on_the_way.insert(*at);
  std::vector<HistoryItem> items;
  for (const auto& [sequence, entry] : timeline.entries()) {
    if (entry.kind == JournalEntry::Kind::snapshot) continue;
    const bool is_state = entry.kind != JournalEntry::Kind::head;
    HistoryItem item{is_state ? sequence : 0, entry.parent, entry.branch, entry.by, entry.asked};
    item.is_current = is_state && sequence == timeline.head();
    item.is_undone = is_state && !on_the_way.count(sequence);
    items.push_back(std::move(item));
  }
  return items;
}

Result<std::vector<std::string>> Session::diff(std::optional<std::size_t> from, std::optional<std::size_t> to) const {
  const Timeline& timeline = impl_->history.timeline();
  const std::size_t later = to.value_or(timeline.head());
  const auto earlier = from ? from : timeline.before(later);
  if (!earlier) return std::vector<std::string>{};
  const auto before = impl_->scene_at(*earlier);
  if (!before) return before.error();
  const auto after = impl_->scene_at(later);
  if (!after) return after.error();
  return differences(*before, *after);
}

}  // namespace roomgen
