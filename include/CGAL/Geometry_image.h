// Copyright (c) 2026 The Vertex_location_optimization authors.
// All rights reserved.
//
// This file is part of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
//
// Author(s)     : The Vertex_location_optimization authors

#ifndef CGAL_GEOMETRY_IMAGE_H
#define CGAL_GEOMETRY_IMAGE_H

#include <CGAL/license/Vertex_location_optimization.h>

#include <CGAL/Geometry_image/Geometry_image.h>
#include <CGAL/Geometry_image/IO.h>
#include <CGAL/Geometry_image/geometry_image_to_polygon_mesh.h>

#endif // CGAL_GEOMETRY_IMAGE_H
