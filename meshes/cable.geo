// A cable that hangs as a quarter of a circle of radius 1, from the mast down to the ground; 8 elements of order 3.
Point(1) = {0, 0, 0};
Point(2) = {-1, 0, 0};
Point(3) = {0, 0, -1};
Circle(1) = {2, 1, 3};
Transfinite Curve {1} = 9;
Mesh.ElementOrder = 3;
Physical Point("mast") = {2};
Physical Curve("cable") = {1};
