// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GEOMETRY_IMAGE_H
#define CGAL_GEOMETRY_IMAGE_H

#include <CGAL/Geometry_image/Geometry_image.h>
#include <CGAL/Geometry_image/IO.h>
#include <CGAL/Geometry_image/geometry_image_to_polygon_mesh.h>

#endif // CGAL_GEOMETRY_IMAGE_H
