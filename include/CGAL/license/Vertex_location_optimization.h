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

// In the form in which CGAL generates this file from Installation/include/CGAL/license/gpl_package_list.txt, where the line
// is
//   Vertex_location_optimization Vertex Location Optimization

// clang-format off
#ifndef CGAL_LICENSE_VERTEX_LOCATION_OPTIMIZATION_H
#define CGAL_LICENSE_VERTEX_LOCATION_OPTIMIZATION_H

#include <CGAL/config.h>
#include <CGAL/license.h>

#ifdef CGAL_VERTEX_LOCATION_OPTIMIZATION_COMMERCIAL_LICENSE

#  if CGAL_VERTEX_LOCATION_OPTIMIZATION_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#    if defined(CGAL_LICENSE_WARNING)

       CGAL_pragma_warning("Your commercial license for CGAL does not cover "
                           "this release of the Vertex Location Optimization package.")
#    endif

#    ifdef CGAL_LICENSE_ERROR
#      error "Your commercial license for CGAL does not cover this release \
              of the Vertex Location Optimization package. \
              You get this error, as you defined CGAL_LICENSE_ERROR."
#    endif // CGAL_LICENSE_ERROR

#  endif // CGAL_VERTEX_LOCATION_OPTIMIZATION_COMMERCIAL_LICENSE < CGAL_RELEASE_DATE

#else // no CGAL_VERTEX_LOCATION_OPTIMIZATION_COMMERCIAL_LICENSE

#  if defined(CGAL_LICENSE_WARNING)
     CGAL_pragma_warning("\nThe macro CGAL_VERTEX_LOCATION_OPTIMIZATION_COMMERCIAL_LICENSE is not defined."
                          "\nYou use the CGAL Vertex Location Optimization package under "
                          "the terms of the GPLv3+.")
#  endif // CGAL_LICENSE_WARNING

#  ifdef CGAL_LICENSE_ERROR
#    error "The macro CGAL_VERTEX_LOCATION_OPTIMIZATION_COMMERCIAL_LICENSE is not defined.\
            You use the CGAL Vertex Location Optimization package under the terms of \
            the GPLv3+. You get this error, as you defined CGAL_LICENSE_ERROR."
#  endif // CGAL_LICENSE_ERROR

#endif // no CGAL_VERTEX_LOCATION_OPTIMIZATION_COMMERCIAL_LICENSE

#endif // CGAL_LICENSE_VERTEX_LOCATION_OPTIMIZATION_H
