// SPDX-License-Identifier: MIT
#include "host_min/scene/textures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host_min/error.hpp"
#include "host_min/scene/one_line.hpp"
#include "host_min/scene/uri.hpp"

namespace gno::host {

namespace {

using Json = nlohmann::json;

constexpr uint64_t kMostTexels = 1ull << 27;                                        // of all images
constexpr int kNearest = 9728, kClamp = 33071, kMirrored = 33648, kRepeat = 10497;  // glTF's numbers, and OpenGL's
constexpr const char* kTransform = "KHR_texture_transform";
constexpr double kLargestCoordinate = 1 << 30;  // 1/256 texel

/// Entry `index` of the file's list `list`; `what` names who asks.
const Json& entryOf(const Json& lists, const char* list, int64_t index, const std::string& what) {
    const auto found = lists.find(list);
    if (found == lists.end() || !found->is_array() || index < 0 || static_cast<size_t>(index) >= found->size())
        throw InputError(fmt::format("{}: entry {} of {} does not exist", what, index, list));
    const Json& entry = (*found)[static_cast<size_t>(index)];
    if (!entry.is_object()) throw InputError(fmt::format("{}: entry {} of {} is no object", what, index, list));
    return entry;
}

int wholeMember(const Json& object, const char* key, int otherwise, const std::string& what) {
    const auto found = object.find(key);
    if (found == object.end()) return otherwise;
    if (!found->is_number_unsigned() || found->get<uint64_t>() > 0x7FFFFFFFull)
        throw InputError(fmt::format("{}: {} is not a whole number in [0, 2^31)", what, key));
    return static_cast<int>(found->get<uint64_t>());
}

Wrap wrapOf(int number, const std::string& what) {
    if (number == kRepeat) return Wrap::repeat;
    if (number == kMirrored) return Wrap::mirrored;
    if (number == kClamp) return Wrap::clamp;
    throw InputError(fmt::format("{}: wrap mode {} is not glTF", what, number));
}

double numberOf(const tinygltf::Value& value, const std::string& what) {
    const double number = value.IsNumber() ? value.GetNumberAsDouble() : NAN;
    if (!std::isfinite(number)) throw InputError(fmt::format("{} is not a finite number", what));
    return number;
}

std::vector<double> numbersOf(const tinygltf::Value& object, const char* key, std::vector<double> otherwise, const std::string& what) {
    if (!object.Has(key)) return otherwise;
    const tinygltf::Value& value = object.Get(key);
    if (!value.IsArray()) throw InputError(fmt::format("{} {} is not an array of numbers", what, key));
    std::vector<double> numbers;
    for (int i = 0; i < static_cast<int>(value.ArrayLen()); ++i) numbers.push_back(numberOf(value.Get(i), fmt::format("{} {}", what, key)));
    return numbers;
}

double memberOf(const tinygltf::Value& object, const char* key, double otherwise, const std::string& what) {
    return object.Has(key) ? numberOf(object.Get(key), fmt::format("{} {}", what, key)) : otherwise;
}

glm::dvec2 pairOf(const tinygltf::Value& object, const char* key, glm::dvec2 otherwise, const std::string& what) {
    if (!object.Has(key)) return otherwise;
    const tinygltf::Value& value = object.Get(key);
    if (!value.IsArray() || value.ArrayLen() != 2) throw InputError(fmt::format("{} {} is not an array of 2 numbers", what, key));
    return {numberOf(value.Get(0), fmt::format("{} {}", what, key)), numberOf(value.Get(1), fmt::format("{} {}", what, key))};
}

/// Counter-clockwise in the image, after the scale: KHR_texture_transform.
TextureTransform transformOf(const tinygltf::Value& extension, const std::string& what) {
    const glm::dvec2 scale = pairOf(extension, "scale", {1, 1}, what);
    const double angle = memberOf(extension, "rotation", 0, what), c = std::cos(angle), s = std::sin(angle);
    return {{{c * scale.x, -s * scale.x}, {s * scale.y, c * scale.y}}, pairOf(extension, "offset", {0, 0}, what)};
}

const tinygltf::Value* extensionOf(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

std::string withName(const std::string& what, const std::string& name) { return name.empty() ? what : fmt::format("{} ({})", what, name); }

}  // namespace

Textures::Textures(const tinygltf::Model& model, const Json& lists, std::filesystem::path folder, Notices& notices)
    : model_(model), lists_(lists), folder_(std::move(folder)), notices_(notices), set_(std::make_shared<MaterialSet>()) {
    for (size_t i = 0; i < model.materials.size(); ++i) readMaterial(model.materials[i], i);
    set_->materials.emplace_back().name = "default";
    places_.emplace_back();
    transmissions_.emplace_back();
}

void Textures::readMaterial(const tinygltf::Material& from, size_t index) {
    const std::string what = fmt::format("material {}", index);
    Material& material = set_->materials.emplace_back();
    Place &place = places_.emplace_back(), &transmitting = transmissions_.emplace_back();
    material.name = oneLine(from.name);
    if (from.alphaMode == "MASK") material.alpha = Material::Alpha::mask;
    if (from.alphaMode == "BLEND") material.alpha = Material::Alpha::blend;
    material.alphaCutoff = static_cast<float>(from.alphaCutoff);
    if (!(material.alphaCutoff >= 0)) throw InputError(fmt::format("{}: alphaCutoff is less than 0", what));
    std::vector<double> factor = from.pbrMetallicRoughness.baseColorFactor;
    const tinygltf::TextureInfo& texture = from.pbrMetallicRoughness.baseColorTexture;
    place.texture = texture.index;
    place.set = texture.texCoord;
    if (const auto* transform = extensionOf(texture.extensions, kTransform)) readTransform(*transform, what, place);
    // Whoever reads this extension goes by it; what the base specification says of the material is for others.
    if (const auto* other = extensionOf(from.extensions, "KHR_materials_pbrSpecularGlossiness")) {
        place = Place();
        factor = numbersOf(*other, "diffuseFactor", {1, 1, 1, 1}, what);
        if (other->Has("diffuseTexture")) readTexture(other->Get("diffuseTexture"), what + " diffuseTexture", place);
    }
    if (factor.size() != 4) throw InputError(fmt::format("{}: its base colour factor does not have 4 numbers", what));
    for (int i = 0; i < 4; ++i) material.baseColor[i] = static_cast<float>(std::clamp(factor[static_cast<size_t>(i)], 0.0, 1.0));
    if (const auto* transmission = extensionOf(from.extensions, "KHR_materials_transmission")) {
        material.transmission = static_cast<float>(std::clamp(memberOf(*transmission, "transmissionFactor", 0, what), 0.0, 1.0));
        if (transmission->Has("transmissionTexture"))
            readTexture(transmission->Get("transmissionTexture"), what + " transmissionTexture", transmitting);
    }
    material.doubleSided = from.doubleSided;
    material.textured = place.texture >= 0;
}

void Textures::readTransform(const tinygltf::Value& extension, const std::string& what, Place& place) {
    place.transform = transformOf(extension, what + " KHR_texture_transform");
    place.set = static_cast<int>(std::clamp(memberOf(extension, "texCoord", place.set, what), 0.0, 1e9));
}

// guardJson saw that it is an object with an index.
void Textures::readTexture(const tinygltf::Value& info, const std::string& what, Place& place) {
    place.texture = static_cast<int>(std::clamp(memberOf(info, "index", -1, what), 0.0, 2147483647.0));
    place.set = static_cast<int>(std::clamp(memberOf(info, "texCoord", 0, what), 0.0, 1e9));
    if (!info.Has("extensions") || !info.Get("extensions").IsObject()) return;
    const tinygltf::Value& extensions = info.Get("extensions");
    if (extensions.Has(kTransform)) readTransform(extensions.Get(kTransform), what, place);
}

void Textures::tell(const char* what, const std::set<uint32_t>& materials, const char* instead) {
    std::vector<std::pair<size_t, std::string>> names;
    for (const uint32_t number : materials) names.emplace_back(number, set_->materials[number].name);
    if (!names.empty()) notices_.add(fmt::format("{} of material{} {}: {}", what, names.size() == 1 ? "" : "s", enumerated(names), instead));
}

std::shared_ptr<const MaterialSet> Textures::take() {
    tell("transmission texture", untinted_, "not used, it lies otherwise than the base colour texture; transmissionFactor alone counts");
    tell("COLOR_0", uneven_, "differs within triangles; each is taken with the mean of its vertices");
    return std::move(set_);
}

uint32_t Textures::use(int index) {
    const auto number = static_cast<uint32_t>(index < 0 ? model_.materials.size() : static_cast<size_t>(index));
    const Material& material = set_->materials[number];
    if (!places_[number].used && !material.isOpaque()) {
        if (material.textured) loadTexture(number);
        if (transmissions_[number].texture >= 0 && material.transmission > 0) loadTransmission(number);
    }
    places_[number].used = true;
    return number;
}

uint32_t Textures::coloured(uint32_t number, const std::array<glm::dvec4, 3>& colours) {
    constexpr size_t kMostExact = 4096;
    const Material from = set_->materials[number];
    glm::dvec4 colour = (colours[0] + colours[1] + colours[2]) / 3.0, counts(from.transmission > 0 ? 1 : 0);
    counts.w = from.alpha == Material::Alpha::opaque ? 0 : 1;
    const auto differs = [&](glm::dvec4 other) { return (other - colours[0]) * counts != glm::dvec4(0); };
    const bool isUneven = differs(colours[1]) || differs(colours[2]);
    if (isUneven) uneven_.insert(number);
    if (!isUneven) colour = colours[0];
    if (isUneven || coloured_.size() >= kMostExact) colour = glm::round(colour * 255.0) / 255.0;
    colour = glm::mix(glm::dvec4(1), colour, counts);
    if (colour == glm::dvec4(1)) return number;
    const glm::vec4 factor(colour);
    const auto [entry, added] =
        coloured_.try_emplace({static_cast<float>(number), factor.x, factor.y, factor.z, factor.w}, static_cast<uint32_t>(set_->materials.size()));
    if (added) {
        set_->materials.push_back(from);
        set_->materials.back().baseColor *= factor;
    }
    return entry->second;
}

Textures::Sampling Textures::samplingOf(const Place& place, uint32_t number) const {
    const std::string what = fmt::format("material {}", number);
    const Json& texture = entryOf(lists_, "textures", place.texture, what);
    const std::string textureName = fmt::format("texture {}", place.texture);
    Sampling result;
    if (const int sampler = wholeMember(texture, "sampler", -1, textureName); sampler >= 0) {
        const Json& from = entryOf(lists_, "samplers", sampler, textureName);
        const std::string samplerName = fmt::format("sampler {}", sampler);
        result.wrapU = wrapOf(wholeMember(from, "wrapS", kRepeat, samplerName), samplerName);
        result.wrapV = wrapOf(wholeMember(from, "wrapT", kRepeat, samplerName), samplerName);
        result.linearFilter = wholeMember(from, "magFilter", 0, samplerName) != kNearest;
    }
    const int source = wholeMember(texture, "source", -1, textureName);
    if (source < 0)
        throw InputError(fmt::format("{} has no PNG or JPEG; {} lets light through: give it one, or make it opaque", textureName,
                                     withName(what, set_->materials[number].name)));
    result.image = static_cast<size_t>(source);
    return result;
}

void Textures::loadTexture(uint32_t number) {
    const Sampling sampling = samplingOf(places_[number], number);
    Material& material = set_->materials[number];
    material.wrapU = sampling.wrapU;
    material.wrapV = sampling.wrapV;
    material.linearFilter = sampling.linearFilter;
    material.image = loadImage(sampling.image);
}

// What passes is colour times transmission, texel by texel, so the texture goes into an image of the material's own. That needs one lookup for both.
void Textures::loadTransmission(uint32_t number) {
    Material& material = set_->materials[number];
    Place &place = places_[number], &transmitting = transmissions_[number];
    Sampling sampling = samplingOf(transmitting, number);
    const TextureImage share = set_->images[static_cast<size_t>(loadImage(sampling.image))];
    TextureImage product{share.width, share.height, std::vector<uint8_t>(share.rgba.size(), 255), true};
    if (material.image < 0) {
        place.set = transmitting.set;
        place.transform = transmitting.transform;
        material.wrapU = sampling.wrapU;
        material.wrapV = sampling.wrapV;
        material.linearFilter = sampling.linearFilter;
    } else {
        const TextureImage& colour = set_->images[static_cast<size_t>(material.image)];
        const bool isSame = place.set == transmitting.set && place.transform == transmitting.transform && sampling.wrapU == material.wrapU &&
                            sampling.wrapV == material.wrapV && sampling.linearFilter == material.linearFilter && colour.width == share.width &&
                            colour.height == share.height;
        if (!isSame) {
            untinted_.insert(number);
            return;
        }
        for (size_t i = 0; i < product.rgba.size(); ++i) product.rgba[i] = i % 4 == 3 ? colour.rgba[i] : linearChannel(colour.rgba[i]);
    }
    for (size_t i = 0; i < product.rgba.size(); ++i)
        if (i % 4 != 3) product.rgba[i] = static_cast<uint8_t>((product.rgba[i] * share.rgba[i - i % 4] + 127) / 255);
    texels_ += uint64_t{product.width} * product.height;
    if (texels_ > kMostTexels) throw InputError(fmt::format("all images together have more than {} texels", kMostTexels));
    material.image = static_cast<int>(set_->images.size());
    set_->images.push_back(std::move(product));
}

int Textures::loadImage(size_t image) {
    const auto [entry, added] = images_.try_emplace(image, static_cast<int>(set_->images.size()));
    if (!added) return entry->second;
    const std::string what = fmt::format("image {}", image);
    set_->images.push_back(decodeImage(imageBytes(image, what), what, kMostTexels - texels_));
    texels_ += uint64_t{set_->images.back().width} * set_->images.back().height;
    return entry->second;
}

std::vector<unsigned char> Textures::imageBytes(size_t image, const std::string& what) const {
    const Json& entry = entryOf(lists_, "images", static_cast<int64_t>(image), "a texture");
    if (const int number = wholeMember(entry, "bufferView", -1, what); number >= 0) {
        if (static_cast<size_t>(number) >= model_.bufferViews.size())
            throw InputError(fmt::format("{}: buffer view {} does not exist", what, number));
        const auto& view = model_.bufferViews[static_cast<size_t>(number)];
        if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= model_.buffers.size())
            throw InputError(fmt::format("{}: buffer {} does not exist", what, view.buffer));
        const auto& data = model_.buffers[static_cast<size_t>(view.buffer)].data;
        if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
            throw InputError(fmt::format("{}: buffer view {} reaches past the end of its buffer", what, number));
        const auto first = data.begin() + static_cast<std::ptrdiff_t>(view.byteOffset);
        return {first, first + static_cast<std::ptrdiff_t>(view.byteLength)};
    }
    const auto uri = entry.find("uri");
    if (uri == entry.end() || !uri->is_string()) throw InputError(fmt::format("{} has neither a buffer view nor a uri", what));
    return readUri(folder_, uri->get<std::string>(), what);
}

// A triangle moves by whole repeats towards 0, on one axis after the other; a mirrored texture repeats every two images, a clamped one does not.
std::array<glm::ivec2, 3> Textures::corners(uint32_t number, const std::array<glm::dvec2, 3>& uv) const {
    const Material& from = set_->materials[number];
    const TextureImage& image = set_->images[static_cast<size_t>(from.image)];
    std::array<glm::dvec2, 3> at;
    for (size_t i = 0; i < 3; ++i) at[i] = places_[number].transform(uv[i]);
    std::array<glm::ivec2, 3> result;
    for (int axis = 0; axis < 2; ++axis) {
        const Wrap wrap = axis == 0 ? from.wrapU : from.wrapV;
        const double size = axis == 0 ? image.width : image.height;
        const double period = wrap == Wrap::mirrored ? 2 : 1;
        const double least = std::min({at[0][axis], at[1][axis], at[2][axis]});
        const double shift = wrap == Wrap::clamp ? 0 : std::floor(least / period) * period;
        for (size_t i = 0; i < 3; ++i) {
            const double texel = std::floor((at[i][axis] - shift) * size * 256 + 0.5);
            if (!(std::abs(texel) < kLargestCoordinate))
                throw InputError(fmt::format("texture coordinates reach over more than {} texels in one triangle", 1 << 22));
            result[i][axis] = static_cast<int>(texel);
        }
    }
    return result;
}

}  // namespace gno::host
