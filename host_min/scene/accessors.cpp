// SPDX-License-Identifier: MIT
#include "host_min/scene/accessors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "host_min/error.hpp"
#include "host_min/scene/extensions.hpp"

namespace gno::host {

namespace {

constexpr size_t kMostNumbers = size_t{1} << 28;  // many accessors may name the same bytes: 2 GiB of doubles are enough

size_t componentBytes(int componentType) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

template <typename T>
void decodeAs(const unsigned char* data, size_t stride, size_t count, int components, bool normalized, double* out) {
    constexpr double kLargest = static_cast<double>(std::numeric_limits<T>::max());
    for (size_t i = 0; i < count; ++i, data += stride) {
        for (int c = 0; c < components; ++c) {
            T raw;
            std::memcpy(&raw, data + static_cast<size_t>(c) * sizeof(T), sizeof(T));
            const auto value = static_cast<double>(raw);
            *out++ = normalized && std::numeric_limits<T>::is_integer ? std::max(value / kLargest, -1.0) : value;
        }
    }
}

void decode(const unsigned char* data, size_t stride, size_t count, int components, int componentType, bool normalized, double* out) {
    switch (componentType) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return decodeAs<int8_t>(data, stride, count, components, normalized, out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return decodeAs<uint8_t>(data, stride, count, components, normalized, out);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return decodeAs<int16_t>(data, stride, count, components, normalized, out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return decodeAs<uint16_t>(data, stride, count, components, normalized, out);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return decodeAs<uint32_t>(data, stride, count, components, normalized, out);
        default:
            return decodeAs<float>(data, stride, count, components, false, out);
    }
}

uint32_t unsignedAt(const unsigned char* data, int componentType) {
    if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *data;
    if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
        uint16_t value = 0;
        std::memcpy(&value, data, sizeof value);
        return value;
    }
    uint32_t value = 0;
    std::memcpy(&value, data, sizeof value);
    return value;
}

bool isUnsigned(int componentType) {
    return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

// Throws where the bytes of a view are not what it stands for: a placeholder without any, or the compressed ones themselves.
void checkUncompressed(const tinygltf::BufferView& view, int number, bool isEmpty) {
    const char* name = meshoptOf(view.extensions);
    if (name == nullptr) return;
    const tinygltf::Value& from = view.extensions.at(name);
    const auto member = [&](const char* key) {
        return from.IsObject() && from.Has(key) && from.Get(key).IsNumber() ? from.Get(key).GetNumberAsDouble() : 0.0;
    };
    const double first = member("byteOffset"), last = first + member("byteLength");
    const auto begin = static_cast<double>(view.byteOffset), end = begin + static_cast<double>(view.byteLength);
    if (!isEmpty && (member("buffer") != view.buffer || last <= begin || end <= first)) return;
    throw InputError(fmt::format("buffer view {} has its data in {} alone, which gnomon does not read; export the model without it", number, name));
}

}  // namespace

Accessors::Accessors(const tinygltf::Model& model) : model_(model) {
    for (const auto& buffer : model.buffers) bytes_ += buffer.data.size();
}

Accessors::Layout Accessors::dense(int bufferView, size_t byteOffset, size_t count, int components, int componentType, std::string_view what) const {
    if (bufferView < 0 || static_cast<size_t>(bufferView) >= model_.bufferViews.size())
        throw InputError(fmt::format("{}: buffer view {} does not exist, there are {}", what, bufferView, model_.bufferViews.size()));
    const auto& view = model_.bufferViews[static_cast<size_t>(bufferView)];
    if (view.buffer < 0 || static_cast<size_t>(view.buffer) >= model_.buffers.size())
        throw InputError(fmt::format("buffer view {}: buffer {} does not exist, there are {}", bufferView, view.buffer, model_.buffers.size()));
    const auto& data = model_.buffers[static_cast<size_t>(view.buffer)].data;
    checkUncompressed(view, bufferView, data.empty());
    if (data.empty()) throw InputError(fmt::format("{}: buffer {} refers to no data", what, view.buffer));
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
        throw InputError(fmt::format("buffer view {} reaches past the end of buffer {} ({} bytes)", bufferView, view.buffer, data.size()));
    const size_t element = componentBytes(componentType) * static_cast<size_t>(components);
    const size_t stride = view.byteStride == 0 ? element : view.byteStride;
    if (stride < element)
        throw InputError(fmt::format("buffer view {}: a byteStride of {} is less than an element of {} bytes", bufferView, stride, element));
    const bool fits =
        byteOffset <= view.byteLength && element <= view.byteLength - byteOffset && count - 1 <= (view.byteLength - byteOffset - element) / stride;
    if (!fits)
        throw InputError(fmt::format("{}: {} elements reach past the end of buffer view {} ({} bytes)", what, count, bufferView, view.byteLength));
    return {data.data() + view.byteOffset + byteOffset, count, stride, components, componentType, false};
}

Accessors::Layout Accessors::layout(int index, std::string_view what) const {
    if (index < 0 || static_cast<size_t>(index) >= model_.accessors.size())
        throw InputError(fmt::format("{}: accessor {} does not exist, there are {}", what, index, model_.accessors.size()));
    const auto& accessor = model_.accessors[static_cast<size_t>(index)];
    const std::string name = fmt::format("accessor {} ({})", index, what);
    const int components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type));
    if (components < 1) throw InputError(fmt::format("{} has an unknown type", name));
    if (componentBytes(accessor.componentType) == 0)
        throw InputError(fmt::format("{}: component type {} is not glTF", name, accessor.componentType));
    if (accessor.count == 0) throw InputError(fmt::format("{} has no elements", name));
    Layout result{nullptr, accessor.count, 0, components, accessor.componentType, accessor.normalized};
    if (accessor.bufferView >= 0) {
        result = dense(accessor.bufferView, accessor.byteOffset, accessor.count, components, accessor.componentType, name);
        result.normalized = accessor.normalized;
    } else if (accessor.count > bytes_) {  // all zero before its sparse values; a mesh of that many vertices has at least as many bytes
        throw InputError(fmt::format("{}: {} elements without a buffer view are more than the file has bytes", name, accessor.count));
    }
    return result;
}

size_t Accessors::count(int accessor, std::string_view what) const { return layout(accessor, what).count; }

int Accessors::type(int accessor, std::string_view what) const {
    (void)layout(accessor, what);
    return model_.accessors[static_cast<size_t>(accessor)].type;
}

void Accessors::applySparse(const tinygltf::Accessor& accessor, const Layout& whole, std::vector<double>& values, std::string_view what) const {
    const auto& sparse = accessor.sparse;
    if (sparse.count < 1 || static_cast<size_t>(sparse.count) > whole.count)
        throw InputError(fmt::format("{}: {} sparse values for {} elements", what, sparse.count, whole.count));
    if (!isUnsigned(sparse.indices.componentType))
        throw InputError(fmt::format("{}: sparse indices of component type {}", what, sparse.indices.componentType));
    if (sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) throw InputError(fmt::format("{}: negative offset of sparse data", what));
    const auto count = static_cast<size_t>(sparse.count);
    const Layout at = dense(sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset), count, 1, sparse.indices.componentType, what);
    const Layout with =
        dense(sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset), count, whole.components, whole.componentType, what);
    for (size_t i = 0; i < count; ++i) {
        const size_t target = unsignedAt(at.data + i * at.stride, at.componentType);
        if (target >= whole.count) throw InputError(fmt::format("{}: sparse index {} is past its {} elements", what, target, whole.count));
        decode(with.data + i * with.stride, with.stride, 1, whole.components, whole.componentType, whole.normalized,
               values.data() + target * static_cast<size_t>(whole.components));
    }
}

const std::vector<double>& Accessors::values(int index, int type, std::string_view what) { return *shared(index, type, what); }

std::shared_ptr<const std::vector<double>> Accessors::shared(int index, int type, std::string_view what) {
    const Layout from = layout(index, what);
    const auto& accessor = model_.accessors[static_cast<size_t>(index)];
    if (accessor.type != type) throw InputError(fmt::format("accessor {} ({}) has the wrong type", index, what));
    auto& decoded = decoded_[index];
    if (decoded) return decoded;
    const size_t numbers = from.count * static_cast<size_t>(from.components);
    decodedNumbers_ += numbers;
    if (decodedNumbers_ > kMostNumbers) throw InputError(fmt::format("its accessors hold more than {} numbers", kMostNumbers));
    auto values = std::make_shared<std::vector<double>>(numbers, 0.0);
    if (from.data != nullptr) decode(from.data, from.stride, from.count, from.components, from.componentType, from.normalized, values->data());
    if (accessor.sparse.isSparse) applySparse(accessor, from, *values, fmt::format("accessor {} ({})", index, what));
    decoded = std::move(values);
    return decoded;
}

std::vector<uint32_t> Accessors::indices(int index, std::string_view what) const {
    const Layout from = layout(index, what);
    if (from.components != 1 || !isUnsigned(from.componentType))
        throw InputError(fmt::format("accessor {} ({}) is not made of unsigned integers", index, what));
    if (model_.accessors[static_cast<size_t>(index)].sparse.isSparse)
        throw InputError(fmt::format("accessor {} ({}): sparse indices are not supported", index, what));
    std::vector<uint32_t> result(from.count, 0);
    if (from.data != nullptr)
        for (size_t i = 0; i < from.count; ++i) result[i] = unsignedAt(from.data + i * from.stride, from.componentType);
    return result;
}

}  // namespace gno::host
