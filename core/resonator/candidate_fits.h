#pragma once

#include "core/resonator/model_fit.h"

#include <cstddef>
#include <optional>
#include <span>

namespace vybeg {

// The fits that the choice of a model weighs against each other, each from the best start at hand.
// The drift of each run is free in all of them (where asked for): it is common to both signals, so
// that it costs the modes' difference nothing, and unfitted it would spoil every comparison.
class CandidateFits {
public:
    CandidateFits(std::span<const ScaledRun> runs, bool drift, const JobControl& job);

    // The split along the direction that still waves see, rotation, decay; no anisotropy.
    Status fit_still();
    // As fit_still(), with the anisotropy. Precondition: still() is there.
    Status fit_still_split();
    // All six rates of a calibrated pair. Precondition: still() is there.
    Status fit_structured();
    // Any M. Precondition: structured() is there.
    Status fit_free();
    // The structured rates and kappa, from kappa = 1 or, where free() is there and has the form
    // of an unbalanced pair, from its kappa. Precondition: structured() is there.
    Status fit_kappa();
    // As fit_kappa(), but with equal damping in all directions.
    Status fit_kappa_alone();

    const ModelFit& still() const { return *still_; }
    const ModelFit& still_split() const { return *still_split_; }
    const ModelFit& structured() const { return *structured_; }
    const ModelFit& free() const { return *free_; }
    const ModelFit& kappa() const { return *kappa_; }
    const ModelFit& kappa_alone() const { return *kappa_alone_; }

    const ModelSpace& still_space() const { return still_space_; }
    ModelSpace still_split_space() const;
    ModelSpace structured_space() const;
    ModelSpace free_space() const;
    ModelSpace kappa_space() const;
    ModelSpace kappa_alone_space() const;

    bool drift() const { return drift_; }

private:
    Status fit(std::optional<ModelFit>& into, const ModelSpace& space, const FitState& start);
    // From another start; keeps the better of both. A start beyond all numbers is passed over.
    Status fit_again(std::optional<ModelFit>& into, const ModelSpace& space, const FitState& start);

    std::span<const ScaledRun> runs_;
    bool drift_;
    const JobControl& job_;
    ModelSpace still_space_;
    std::optional<FitState> pencil_;
    std::optional<ModelFit> still_;
    std::optional<ModelFit> still_split_;
    std::optional<ModelFit> structured_;
    std::optional<ModelFit> free_;
    std::optional<ModelFit> kappa_;
    std::optional<ModelFit> kappa_alone_;
};

}  // namespace vybeg
