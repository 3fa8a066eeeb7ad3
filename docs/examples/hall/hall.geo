// A hall of three portal frames, 12 m wide, 4 m high at the eaves, 5 m apart.
width = 12; height = 4; rise = 1.2; bay = 5;
Mesh.ElementOrder = 2;
For i In {0:2}
  Point(10*i + 1) = {0, bay*i, 0};
  Point(10*i + 2) = {0, bay*i, height};
  Point(10*i + 3) = {width/2, bay*i, height + rise};
  Point(10*i + 4) = {width, bay*i, height};
  Point(10*i + 5) = {width, bay*i, 0};
  Line(10*i + 1) = {10*i + 1, 10*i + 2};
  Line(10*i + 2) = {10*i + 5, 10*i + 4};
  Line(10*i + 3) = {10*i + 2, 10*i + 3};
  Line(10*i + 4) = {10*i + 4, 10*i + 3};
EndFor
For i In {0:1}
  For k In {2:4}
    Line(100 + 10*i + k) = {10*i + k, 10*i + 10 + k};
  EndFor
EndFor
// Crossed braces in walls and roof of the first bay.
Line(201) = {1, 12}; Line(202) = {11, 2};
Line(203) = {5, 14}; Line(204) = {15, 4};
Line(205) = {2, 13}; Line(206) = {12, 3};
Line(207) = {4, 13}; Line(208) = {14, 3};
Transfinite Line {1:204} = 5;
Transfinite Line {201:208} = 3;
Physical Line("columns") = {1, 2, 11, 12, 21, 22};
Physical Line("rafters") = {3, 4, 13, 14, 23, 24};
Physical Line("purlins") = {102:104, 112:114};
Physical Line("braces") = {201:208};
Physical Point("ridge") = {3};
