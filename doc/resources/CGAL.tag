<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>
<!-- The entities of CGAL that the manual refers to, and where CGAL's manual has them. -->
<tagfile>
  <compound kind="group">
    <name>bgl_namedparameters</name>
    <title>Named Parameters</title>
    <filename>BGL/group__bgl__namedparameters.html</filename>
  </compound>
  <compound kind="group">
    <name>PkgPolygonMeshProcessing</name>
    <title>Polygon Mesh Processing</title>
    <filename>Polygon_mesh_processing/index.html</filename>
  </compound>
  <compound kind="group">
    <name>PkgSurfaceMeshParameterization</name>
    <title>Triangulated Surface Mesh Parameterization</title>
    <filename>Surface_mesh_parameterization/index.html</filename>
  </compound>
  <compound kind="page">
    <name>thirdparty</name>
    <title>Third Party Libraries</title>
    <filename>Manual/thirdparty.html</filename>
    <docanchor file="Manual/thirdparty.html" title="Eigen">thirdpartyEigen</docanchor>
  </compound>
  <compound kind="page">
    <name>licensesGPL</name>
    <title>GPL</title>
    <filename>Manual/license.html</filename>
  </compound>
  <compound kind="class"><name>FaceGraph</name><filename>BGL/classFaceGraph.html</filename></compound>
  <compound kind="class"><name>FaceListGraph</name><filename>BGL/classFaceListGraph.html</filename></compound>
  <compound kind="class"><name>EdgeListGraph</name><filename>BGL/classEdgeListGraph.html</filename></compound>
  <compound kind="class"><name>MutableFaceGraph</name><filename>BGL/classMutableFaceGraph.html</filename></compound>
  <compound kind="class"><name>HalfedgeListGraph</name><filename>BGL/classHalfedgeListGraph.html</filename></compound>
  <compound kind="class"><name>VertexListGraph</name><filename>BGL/classVertexListGraph.html</filename></compound>
  <compound kind="class"><name>Kernel</name><filename>Kernel_23/classKernel.html</filename></compound>
</tagfile>
