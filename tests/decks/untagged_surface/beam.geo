Point(1) = {0, 0, 0, 50}; Point(2) = {100, 0, 0, 50}; Point(3) = {100, 100, 0, 50}; Point(4) = {0, 100, 0, 50};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Curve("boundary:left") = {4};
Physical Curve("boundary:right") = {2};
