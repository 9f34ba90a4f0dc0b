// SPDX-License-Identifier: GPL-3.0-or-later
// What differs between the versions of MeshLab that the plugin is built for. Nothing else looks at
// the version.
#pragma once

#include <common/parameters/rich_parameter_list.h>

#if !__has_include(<common/parameters/rich_parameter/rich_file_open.h>)
using RichFileOpen = RichOpenFile; // its name up to 2022.02
#endif
