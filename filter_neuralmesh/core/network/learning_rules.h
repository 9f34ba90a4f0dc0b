// SPDX-License-Identifier: GPL-3.0-or-later
// Where growth departs from the paper: each rule in its two forms, side by side.
#pragma once

#include "neuralmesh/parameters.h"

namespace neuralmesh {

/// Samples for each vertex that tell where the target space is, at step 6; with the paper's rules.
inline constexpr int samplesOfSupport = 12;
inline constexpr int samplesOfSupportInPaper = 6;

struct LearningRules {
    /// Step 2. The paper's winner is the nearest vertex. Where the nearest face is of another
    /// sheet, here it is the nearest corner of that face: otherwise each of two walls that are
    /// closer than their vertices is drawn to the samples of both, and they become one in the
    /// middle. Not while the network is young, which is still finding the limbs of its target.
    bool winnerIsOnNearestSheet;

    /// Steps 2 to 4. In the paper the network learns from one sample after the other. Here it
    /// learns from a batch of samples at once, see BatchLearning, where it starts from the shape of
    /// the data. A network that has yet to find the limbs of its target needs them one by one: by
    /// batches, the sheet that closes a scan of one side is laid onto the scan.
    bool learnsByBatches;

    /// Step 4. In the paper a signal counts 1. Here it counts by the sample's distance to the
    /// surface, so that vertices go where the error is: see SignalActivity.
    bool signalsCountByDistance;

    /// Step 5. The paper's split halves the star. Here it is the one that leaves the evenest
    /// valences.
    bool splitsEvenValences;

    /// Step 5. The paper's λ is the same throughout. Here it is half as long while the network is
    /// young: growing slowly there gives the webs between limbs time to settle. Of 8 seeds on dino,
    /// webs of a tenth of the diagonal were left in all with 4 λ below 200 vertices, in half with
    /// λ, in one with λ / 2 below 500.
    bool youngSplitTwiceAsOften;

    /// Step 6. The paper's collapses leave webs. In both forms edges that span a void are flipped
    /// away; here whole webs are taken out, too.
    bool websAreTakenOut;

    /// Step 6. Samples for each vertex that tell where the target space is.
    int supportPerVertex;

    /// The paper's rules.
    static constexpr LearningRules ofPaper()
    {
        return {false, false, false, false, false, false, samplesOfSupportInPaper};
    }

    /// The rules that measured best.
    static constexpr LearningRules refined()
    {
        return {true, true, true, true, true, true, samplesOfSupport};
    }

    static constexpr LearningRules of(SplitRule rule)
    {
        return rule == SplitRule::paper ? ofPaper() : refined();
    }
};

} // namespace neuralmesh
