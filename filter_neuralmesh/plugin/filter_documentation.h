// SPDX-License-Identifier: GPL-3.0-or-later
// What the dialogs say, for those who have no dialog: PyMeshLab hands neither on to Python.
#pragma once

#include "filter_neuralmesh.h"

/// JSON: a list of filters, each with "name" (in Python), "title", "info" (HTML), and "parameters",
/// each of these with "name", "title", "help", "advanced" and, for enumerations, "choices".
QByteArray documentationOf(FilterNeuralMesh &plugin);

/// The same as a C function of the library, for Python's ctypes. Lives as long as the library.
extern "C" Q_DECL_EXPORT const char *neuralmesh_documentation();
