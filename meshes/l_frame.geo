// Two legs that meet in a rigid corner, in one group; 4 and 3 elements of order 2.
Point(1) = {0, 0, 0};
Point(2) = {0, 0, 2};
Point(3) = {1.5, 0, 2};
Line(1) = {1, 2};
Line(2) = {2, 3};
Transfinite Curve {1} = 5;
Transfinite Curve {2} = 4;
Mesh.ElementOrder = 2;
Physical Point("corner") = {2};
Physical Curve("frame") = {1, 2};
