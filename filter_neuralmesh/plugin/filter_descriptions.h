// SPDX-License-Identifier: GPL-3.0-or-later
// What the host shows about each filter, as HTML.
#pragma once

#include <QString>

QString aboutReconstruction();
QString aboutImplicitSurface();
QString aboutParametricSurface();
