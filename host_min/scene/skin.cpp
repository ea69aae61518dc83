// SPDX-License-Identifier: MIT
// Skins and morph targets, evaluated in double.
#include <fmt/format.h>

#include <cmath>

#include "host_min/error.hpp"
#include "host_min/scene/scene_data.hpp"

namespace gno::host {

std::vector<SkinData> loadSkins(const tinygltf::Model& model, Accessors& accessors) {
    std::vector<SkinData> skins;
    for (size_t s = 0; s < model.skins.size(); ++s) {
        const tinygltf::Skin& from = model.skins[s];
        const std::string what = fmt::format("skin {}", s);
        SkinData skin;
        if (from.joints.empty()) throw InputError(what + " has no joints");
        if (from.skeleton >= static_cast<int>(model.nodes.size()))
            throw InputError(fmt::format("{}: its skeleton is node {}, which does not exist", what, from.skeleton));
        for (const int joint : from.joints) {
            if (joint < 0 || static_cast<size_t>(joint) >= model.nodes.size()) throw InputError(fmt::format("{}: joint {} is no node", what, joint));
            skin.joints.push_back(static_cast<uint32_t>(joint));
        }
        skin.inverseBind.assign(skin.joints.size(), glm::dmat4(1.0));
        if (from.inverseBindMatrices >= 0) {
            const auto& values = accessors.values(from.inverseBindMatrices, TINYGLTF_TYPE_MAT4, what + " inverse bind matrices");
            if (values.size() < skin.joints.size() * 16) throw InputError(what + " has fewer inverse bind matrices than joints");
            for (size_t j = 0; j < skin.joints.size(); ++j) {
                for (size_t i = 0; i < 16; ++i) skin.inverseBind[j][static_cast<int>(i / 4)][static_cast<int>(i % 4)] = values[j * 16 + i];
                checkMatrix(skin.inverseBind[j], fmt::format("{} joint {}", what, j));
            }
        }
        skins.push_back(std::move(skin));
    }
    return skins;
}

void loadInfluences(const tinygltf::Primitive& primitive, Accessors& accessors, const std::vector<uint32_t>& kept, PrimitiveData& result) {
    std::vector<const std::vector<double>*> joints, weights;
    for (int set = 0; set < 8; ++set) {
        const auto joint = primitive.attributes.find(fmt::format("JOINTS_{}", set));
        const auto weight = primitive.attributes.find(fmt::format("WEIGHTS_{}", set));
        if (joint == primitive.attributes.end() || weight == primitive.attributes.end()) break;
        joints.push_back(&accessors.values(joint->second, TINYGLTF_TYPE_VEC4, "JOINTS"));
        weights.push_back(&accessors.values(weight->second, TINYGLTF_TYPE_VEC4, "WEIGHTS"));
    }
    if (joints.empty()) return;
    result.influenceStart.push_back(0);
    for (const uint32_t vertex : kept) {
        double sum = 0;
        const size_t first = result.influences.size();
        for (size_t set = 0; set < joints.size(); ++set) {
            for (size_t i = size_t{vertex} * 4; i < size_t{vertex} * 4 + 4; ++i) {
                const double joint = (*joints[set])[i], weight = (*weights[set])[i];
                if (!(weight >= 0 && weight <= kLargestNumber))
                    throw InputError(fmt::format("vertex {}: a skin weight is negative or not finite", vertex));
                if (weight == 0) continue;
                if (!(joint >= 0 && joint <= 65535 && joint == std::floor(joint)))
                    throw InputError(fmt::format("vertex {}: a joint is no small whole number", vertex));
                result.influences.push_back({static_cast<uint32_t>(joint), weight});
                result.jointCount = std::max(result.jointCount, static_cast<uint32_t>(joint) + 1);
                sum += weight;
            }
        }
        if (result.influences.size() == first) {  // no weight at all: its first joint carries it
            const double joint = (*joints[0])[size_t{vertex} * 4];
            if (!(joint >= 0 && joint <= 65535)) throw InputError(fmt::format("vertex {}: a joint is no small whole number", vertex));
            result.influences.push_back({static_cast<uint32_t>(joint), 1.0});
            result.jointCount = std::max(result.jointCount, static_cast<uint32_t>(joint) + 1);
            sum = 1;
        }
        for (size_t i = first; i < result.influences.size(); ++i) result.influences[i].weight /= sum;
        result.influenceStart.push_back(static_cast<uint32_t>(result.influences.size()));
    }
}

std::vector<glm::dmat4> jointMatrices(const SkinData& skin, const Pose& pose) {
    std::vector<glm::dmat4> matrices(skin.joints.size());
    for (size_t j = 0; j < matrices.size(); ++j) matrices[j] = pose.world[skin.joints[j]] * skin.inverseBind[j];
    return matrices;
}

void placeVertices(const PrimitiveData& primitive, const std::vector<double>& weights, const glm::dmat4& world,
                   const std::vector<glm::dmat4>& joints, std::vector<glm::dvec3>& out) {
    const bool isSkinned = !joints.empty() && !primitive.influenceStart.empty();
    out.resize(primitive.positions.size());
    for (size_t v = 0; v < primitive.positions.size(); ++v) {
        glm::dvec3 position = primitive.positions[v];
        for (size_t t = 0; t < primitive.targets.size(); ++t)
            if (!primitive.targets[t].empty()) position += weights[t] * primitive.targets[t][v];
        const glm::dvec4 local(position, 1.0);
        if (isSkinned) {
            glm::dvec3 sum(0.0);
            for (uint32_t i = primitive.influenceStart[v]; i < primitive.influenceStart[v + 1]; ++i)
                sum += primitive.influences[i].weight * glm::dvec3(joints[primitive.influences[i].joint] * local);
            out[v] = sum;
        } else {
            out[v] = glm::dvec3(world * local);
        }
    }
}

}  // namespace gno::host
