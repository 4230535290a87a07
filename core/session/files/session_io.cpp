#include "core/session/files/session_io.h"

#include <algorithm>
#include <cmath>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/samples/samples.h"

namespace chartflood {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr const char* kChartsAsked = "charts-asked";  // false: K is a default
constexpr int kDeepest = 32;                          // of nested values: ours have 3
constexpr std::size_t kLargestFile = 256'000'000;     // bytes

// Writing.

Json parametersJson(const Parameters& parameters) {
  Json json = Json::object();
  for (const ParameterInfo& info : parameterTable()) {
    std::visit([&](const auto& value) { json[info.id] = value; }, parameterValue(parameters, info));
  }
  // Older programs take any number for one that is asked for, as it is unless this says otherwise.
  if (!parameters.chartsAsked) json[kChartsAsked] = false;
  return json;
}

Json modelJson(const SessionModel& model, const std::filesystem::path& target) {
  if (model.file.empty()) return {{"sample", model.sample}, {"triangles", model.triangles}};
  if (target.empty()) {
    return {{"relative", model.file.filename().string()}, {"checksum", model.checksum}};
  }
  std::error_code error;
  const auto file = std::filesystem::absolute(model.file, error).lexically_normal();
  const auto folder = std::filesystem::absolute(target, error).lexically_normal().parent_path();
  const std::string relative = file.lexically_relative(folder).string();
  Json json = Json::object();
  if (!relative.empty()) json["relative"] = relative;
  json["file"] = file.string();
  json["checksum"] = model.checksum;
  return json;
}

Json seedsJson(const std::vector<PlacedSeed>& seeds) {
  Json json = Json::array();
  for (const PlacedSeed& seed : seeds) {
    json.push_back({{"face", seed.face}, {"locked", seed.locked}});
  }
  return json;
}

Json hintsJson(const EdgeHints& hints) {
  Json json = {{"cut", Json::array()}, {"never", Json::array()}};
  for (const EdgeHint& hint : hints) {
    json[hint.kind == HintKind::Cut ? "cut" : "never"].push_back({hint.a, hint.b});
  }
  return json;
}

Json normalsJson(const std::vector<glm::dvec3>& normals) {
  Json json = Json::array();
  for (const glm::dvec3& n : normals) json.push_back({n.x, n.y, n.z});
  return json;
}

Json fastJson(const std::optional<FastFlood>& fast) {
  return fast ? Json{{"starts", fast->starts}, {"band", fast->band}} : Json(nullptr);
}

Json viewJson(const std::map<std::string, SessionValue>& view) {
  Json json = Json::object();
  for (const auto& [name, value] : view) {
    std::visit([&, &key = name](const auto& plain) { json[key] = plain; }, value);
  }
  return json;
}

/// Puts what this version does not know beside what it knows.
void addUnknown(Json& json, const Json& unknown) {
  for (const auto& [key, value] : unknown.items()) {
    if (!json.contains(key)) {
      json[key] = value;
    } else if (json[key].is_object() && value.is_object()) {
      addUnknown(json[key], value);
    }
  }
}

// Reading.

/// Takes known values out of an object; what is left over is unknown.
class Reader {
 public:
  Reader(Json json, std::string where, std::vector<std::string>& warnings)
      : json_(std::move(json)), where_(std::move(where)), warnings_(warnings) {}

  bool has(const char* key) const { return json_.contains(key); }
  Json take(const std::string& key) {
    const auto found = json_.find(key);
    if (found == json_.end()) return nullptr;
    Json value = std::move(*found);
    json_.erase(found);
    return value;
  }
  std::string text(const char* key) {
    if (!has(key)) return "";
    const Json value = take(key);
    if (value.is_string()) return value.get<std::string>();
    unusable(key);
    return "";
  }
  bool flag(const char* key) {
    if (!has(key)) return false;
    const Json value = take(key);
    if (value.is_boolean()) return value.get<bool>();
    unusable(key);
    return false;
  }
  std::size_t count(const char* key) {
    if (!has(key)) return 0;
    const Json value = take(key);
    if (value.is_number_unsigned()) return value.get<std::size_t>();
    unusable(key);
    return 0;
  }
  /// An object or array under a key; an empty one when it is absent or something else.
  Json part(const char* key, bool isArray) {
    Json value = take(key);
    if (isArray ? value.is_array() : value.is_object()) return value;
    if (!value.is_null()) unusable(key);
    return isArray ? Json::array() : Json::object();
  }
  void unusable(const std::string& key) {
    warnings_.push_back("The session's value of '" + where_ + key +
                        "' cannot be used and was left out.");
  }
  /// What nobody asked for.
  const Json& rest() const { return json_; }

 private:
  Json json_;
  std::string where_;
  std::vector<std::string>& warnings_;
};

Json parseText(std::string_view text, const std::string& name) {
  bool tooDeep = false;
  const auto watch = [&](int depth, Json::parse_event_t, Json&) {
    tooDeep = tooDeep || depth > kDeepest;
    return !tooDeep;
  };
  Json json;
  try {
    json = Json::parse(text, watch);
  } catch (const Json::exception&) {
    throw ReadError(name, "it is not a whole session file (broken JSON)");
  }
  if (tooDeep || !json.is_object() || !json.contains("chartflood-session")) {
    throw ReadError(name, "it is not a session file of chartflood");
  }
  return json;
}

void checkVersion(const Json& version, const std::string& name) {
  if (!version.is_number_integer() || version < 1) {
    throw ReadError(name, "its version is not a number from 1 on");
  }
  if (version > kVersion) {
    throw ReadError(name, "it was written by a newer chartflood (session version " +
                              version.dump() + ", this one reads " + std::to_string(kVersion) +
                              ")");
  }
}

/// Where the model of a session may be.
struct ModelPlaces {
  std::string relative, absolute;
};

/// The model as it is written down; its file is yet to be found.
SessionModel readModel(Reader& reader, const std::string& session, ModelPlaces& places) {
  SessionModel model;
  model.sample = reader.text("sample");
  model.triangles = reader.count("triangles");
  places = {reader.text("relative"), reader.text("file")};
  model.checksum = reader.text("checksum");
  if (!model.sample.empty()) {
    const auto samples = sampleTable();
    const bool known = std::any_of(samples.begin(), samples.end(), [&](const SampleInfo& sample) {
      return model.sample == sample.id;
    });
    if (!known) {
      throw ReadError(session, "its sample '" + model.sample + "' is not known here");
    }
    if (model.triangles > kMostSampleTriangles) {
      throw ReadError(session, "its sample is to have " + std::to_string(model.triangles) +
                                   " triangles; give a number from 1 to " +
                                   std::to_string(kMostSampleTriangles));
    }
  }
  return model;
}

std::filesystem::path findModel(const ModelPlaces& places, const std::filesystem::path& session) {
  const auto& [relative, absolute] = places;
  if (relative.empty() && absolute.empty()) {
    throw ReadError(session.string(), "it does not say which model it belongs to");
  }
  std::error_code error;
  std::filesystem::path beside = (session.parent_path() / relative).lexically_normal();
  if (!relative.empty() && std::filesystem::exists(beside, error)) {
    return beside;
  }
  if (!absolute.empty() && std::filesystem::exists(absolute, error)) return absolute;
  std::string looked = relative.empty() ? "" : beside.string();
  if (!absolute.empty() && absolute != looked) looked += (looked.empty() ? "" : " and ") + absolute;
  throw ReadError(session.string(), "its model is not there any more; looked for " + looked);
}

Parameters readParameters(Reader& reader) {
  Parameters parameters;
  for (const ParameterInfo& info : parameterTable()) {
    if (!reader.has(info.id)) continue;
    const Json json = reader.take(info.id);
    const ParameterValue kind = parameterDefault(info);
    try {
      if (std::holds_alternative<bool>(kind) && json.is_boolean()) {
        setParameter(parameters, info, json.get<bool>());
      } else if (std::holds_alternative<int>(kind) && json.is_number_integer()) {
        // By its text: numbers that do not fit are out of range and must not wrap.
        setParameterFromText(parameters, info, json.dump());
      } else if (std::holds_alternative<double>(kind) && json.is_number()) {
        setParameter(parameters, info, json.get<double>());
      } else if (std::holds_alternative<std::string>(kind) && json.is_string()) {
        setParameter(parameters, info, json.get<std::string>());
      } else {
        reader.unusable(info.id);
      }
    } catch (const UsageError&) {
      reader.unusable(info.id);
    }
  }
  if (reader.has(kChartsAsked)) parameters.chartsAsked = reader.flag(kChartsAsked);
  return parameters;
}

bool isNormal(const Json& json) {
  return json.is_array() && json.size() == 3 &&
         std::all_of(json.begin(), json.end(), [](const Json& part) {
           return part.is_number() && std::abs(part.get<double>()) <= 1.001;
         });
}

bool isFace(const Json& json) {
  return json.is_number_unsigned() && json.get<std::uint64_t>() < kNone;
}

std::vector<PlacedSeed> readSeeds(Reader& reader) {
  std::vector<PlacedSeed> seeds;
  bool all = true;
  for (const Json& json : reader.part("seeds", true)) {
    const bool usable = json.is_object() && json.contains("face") && isFace(json["face"]);
    all = all && usable;
    if (!usable) continue;
    const bool locked = json.contains("locked") && json["locked"] == true;
    seeds.push_back({json["face"].get<Index>(), locked});
  }
  if (!all) reader.unusable("seeds");
  return seeds;
}

/// Pairs of vertices under the name of each kind.
EdgeHints readHints(Reader& parent, std::vector<std::string>& warnings) {
  Reader reader(parent.part("hints", false), "hints/", warnings);
  EdgeHints hints;
  for (const auto& [key, kind] : {std::pair{"cut", HintKind::Cut}, {"never", HintKind::Never}}) {
    bool all = true;
    for (const Json& edge : reader.part(key, true)) {
      const bool usable = edge.is_array() && edge.size() == 2 && isFace(edge[0]) && isFace(edge[1]);
      all = all && usable;
      if (usable) addHint(hints, edge[0].get<Index>(), edge[1].get<Index>(), kind);
    }
    if (!all) reader.unusable(key);
  }
  return hints;
}

FloodMoment readCharts(Reader& parent, std::vector<std::string>& warnings) {
  Reader reader(parent.part("charts", false), "charts/", warnings);
  FloodMoment moment;
  bool usable = true;
  for (const Json& face : reader.part("seeds", true)) {
    usable = usable && isFace(face);
    if (usable) moment.start.seeds.push_back(face.get<Index>());
  }
  for (const Json& offset : reader.part("offsets", true)) {
    usable = usable && offset.is_number() && std::isfinite(offset.get<double>());
    if (usable) moment.start.offsets.push_back(offset.get<double>());
  }
  for (const Json& normal : reader.part("normals", true)) {
    usable = usable && isNormal(normal);
    if (!usable) continue;
    moment.start.normals.emplace_back(normal[0].get<double>(), normal[1].get<double>(),
                                      normal[2].get<double>());
  }
  moment.taken = reader.count("taken");
  moment.finished = reader.flag("finished");
  if (const Json seed = reader.take("creases"); seed.is_number_unsigned()) {
    moment.start.creases = static_cast<std::uint32_t>(seed.get<std::uint64_t>());
  }
  if (const Json json = reader.take("fast"); json.is_object()) {
    Reader fast(json, "charts/fast/", warnings);
    moment.start.fast.emplace();
    for (const Json& face : fast.part("starts", true)) {
      usable = usable && isFace(face);
      if (usable) moment.start.fast->starts.push_back(face.get<Index>());
    }
    for (const Json& offset : fast.part("band", true)) {
      usable = usable && offset.is_number() && std::isfinite(offset.get<double>());
      if (usable) moment.start.fast->band.push_back(offset.get<double>());
    }
    const std::size_t band = moment.start.fast->band.size();
    usable = usable && (band == 0 || band == moment.start.seeds.size());
  }
  usable =
      usable &&
      (moment.start.offsets.empty() || moment.start.offsets.size() == moment.start.seeds.size()) &&
      (moment.start.normals.empty() || moment.start.normals.size() == moment.start.seeds.size());
  if (usable) return moment;
  parent.unusable("charts");
  return {};
}

std::map<std::string, SessionValue> readView(Reader& parent) {
  std::map<std::string, SessionValue> view;
  const Json json = parent.part("view", false);
  for (const auto& [name, value] : json.items()) {
    const bool numbers =
        value.is_array() && std::all_of(value.begin(), value.end(),
                                        [](const Json& entry) { return entry.is_number(); });
    if (value.is_boolean()) {
      view[name] = value.get<bool>();
    } else if (value.is_number()) {
      view[name] = value.get<double>();
    } else if (value.is_string()) {
      view[name] = value.get<std::string>();
    } else if (numbers) {
      view[name] = value.get<std::vector<double>>();
    } else {
      parent.unusable("view/" + name);
    }
  }
  return view;
}

/// Keeps what was not asked for, and says so.
void keepUnknown(SessionFile& session, const Json& top,
                 const std::vector<std::pair<const char*, const Json*>>& parts) {
  Json unknown = top;
  std::string names;
  const auto name = [&](const Json& json, const std::string& where) {
    for (const auto& item : json.items()) {
      names += (names.empty() ? "'" : ", '") + where + item.key() + "'";
    }
  };
  name(top, "");
  for (const auto& [key, json] : parts) {
    name(*json, std::string(key) + "/");
    if (!json->empty()) unknown[key] = *json;
  }
  if (names.empty()) return;
  session.unknown = unknown.dump(-1, ' ', false, Json::error_handler_t::replace);
  session.warnings.push_back("The session holds what this version does not know (" + names +
                             "); it is kept when the session is saved again.");
}

/// `find` gives the model's file.
template <class Find>
SessionFile readText(std::string_view text, const std::string& name, const Find& find) {
  SessionFile session;
  session.folder = std::filesystem::path(name).parent_path();
  if (session.folder.empty()) session.folder = ".";
  Reader top(parseText(text, name), "", session.warnings);
  checkVersion(top.take("chartflood-session"), name);
  Reader model(top.part("model", false), "model/", session.warnings);
  ModelPlaces places;
  session.model = readModel(model, name, places);
  if (session.model.sample.empty()) session.model.file = find(places);
  Reader parameters(top.part("parameters", false), "parameters/", session.warnings);
  session.parameters = readParameters(parameters);
  session.seeds = readSeeds(top);
  session.hints = readHints(top, session.warnings);
  session.charts = readCharts(top, session.warnings);
  session.view = readView(top);
  session.continues = top.text("continues");
  keepUnknown(session, top.rest(), {{"model", &model.rest()}, {"parameters", &parameters.rest()}});
  return session;
}

}  // namespace

std::string sessionText(const SessionFile& session, const std::filesystem::path& target) {
  Json json = {
      {"chartflood-session", kVersion},
      {"model", modelJson(session.model, target)},
      {"parameters", parametersJson(session.parameters)},
      {"seeds", seedsJson(session.seeds)},
      {"hints", hintsJson(session.hints)},
      {"charts",
       {{"seeds", session.charts.start.seeds},
        {"offsets", session.charts.start.offsets},
        {"normals", normalsJson(session.charts.start.normals)},
        {"creases",
         session.charts.start.creases ? Json(*session.charts.start.creases) : Json(nullptr)},
        {"fast", fastJson(session.charts.start.fast)},
        {"taken", session.charts.taken},
        {"finished", session.charts.finished}}},
      {"view", viewJson(session.view)},
  };
  if (!session.continues.empty()) json["continues"] = session.continues.string();
  if (!session.unknown.empty()) {
    const Json unknown = Json::parse(session.unknown, nullptr, false);
    if (unknown.is_object()) addUnknown(json, unknown);
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

SessionFile readSession(const std::filesystem::path& file) {
  const std::string name = file.string();
  const FileBytes content(file, {kLargestFile, "a session"});
  return readText(content.view(), name,
                  [&](const ModelPlaces& places) { return findModel(places, file); });
}

SessionFile readSessionText(std::string_view text, const std::string& name,
                            const std::filesystem::path& model) {
  return readText(text, name, [&](const ModelPlaces&) { return model; });
}

}  // namespace chartflood
