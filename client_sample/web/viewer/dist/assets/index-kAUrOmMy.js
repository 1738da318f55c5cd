const __vite__mapDeps=(i,m=__vite__mapDeps,d=(m.f||(m.f=["./made_tiles-DE7J4BpS.js","./tiles-CUUo1xOp.js","./uniform-dDORJD-b.js","./published-CHmVgrn6.js","./get-CaJkPnCu.js","./world-DAhg8ATW.js","./local_chunks-EwCQRZsj.js","./runs-BWDnRD1C.js","./making-CZVmgMFT.js","./overlay-11xWCkbW.js","./screen-CCNglB2u.js","./dom-vR6jVJSK.js"])))=>i.map(i=>d[i]);
import{_ as il,w as tc,a as ec,b as Vd,T as Wd,f as Xd,r as sl,c as qd,d as $d,e as Yd,g as Kd}from"./token_dialog-CWGh164C.js";import{b as Ut,e as rl,F as Zd,r as Jd}from"./runs-BWDnRD1C.js";import{g as Qd,H as io,h as au,d as ol}from"./get-CaJkPnCu.js";import{T as Bt,m as xs,k as Jn,c as lu,a as cu,b as jd,u as hu,s as nc,o as tf,V as ef}from"./uniform-dDORJD-b.js";import{C as uu,c as nf,a as sf,f as rf,b as of}from"./base-uHmBtDiM.js";import{t as so,f as ic,a as af,q as sc}from"./tiles-CUUo1xOp.js";import{f as dt,m as Ke,s as ee,a as lf}from"./dom-vR6jVJSK.js";import{c as cf,l as Ko,M as rc,p as hf,w as du}from"./server-DI7u6T5Y.js";const oc=new Set;function uf(i,t){const e=[["talus:first",i.firstFrameMs],["talus:complete",i.completeMs]];for(const[n,s]of e)s===null||oc.has(n)||(oc.add(n),performance.mark(n,{startTime:t+s}))}/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const al="187",df=0,ac=1,ff=2,_r=1,pf=2,gs=3,ei=0,ke=1,xn=2,Bi=0,Ss=1,lc=2,cc=3,hc=4,mf=5,Fi=100,gf=101,_f=102,vf=103,xf=104,Sf=200,Mf=201,wf=202,yf=203,fu=204,pu=205,Ef=206,bf=207,Tf=208,Af=209,Rf=210,Cf=211,Pf=212,Lf=213,If=214,Zo=0,Jo=1,Qo=2,Es=3,jo=4,ta=5,ea=6,na=7,mu=0,Df=1,Nf=2,Bn=0,gu=1,_u=2,vu=3,xu=4,Su=5,Mu=6,wu=7,yu=300,Vi=301,bs=302,ro=303,oo=304,Rr=1e3,kn=1001,ia=1002,me=1003,Uf=1004,Us=1005,Ie=1006,ao=1007,Qn=1008,Ze=1009,Eu=1010,bu=1011,Ts=1012,ll=1013,tn=1014,Je=1015,dn=1016,cl=1017,hl=1018,Wi=1020,Tu=35902,Au=35899,Ru=1021,Cu=1022,Qe=1023,ni=1026,jn=1027,Pu=1028,ul=1029,ii=1030,$r=1031,dl=1033,vr=33776,xr=33777,Sr=33778,Mr=33779,sa=35840,ra=35841,oa=35842,aa=35843,la=36196,ca=37492,ha=37496,ua=37488,da=37489,Cr=37490,fa=37491,pa=37808,ma=37809,ga=37810,_a=37811,va=37812,xa=37813,Sa=37814,Ma=37815,wa=37816,ya=37817,Ea=37818,ba=37819,Ta=37820,Aa=37821,Ra=36492,Ca=36494,Pa=36495,La=36283,Ia=36284,Pr=36285,Da=36286,Ff=3200,uc=0,Of=1,Nn="",Ye="srgb",Lr="srgb-linear",Ir="linear",te="srgb",lo=7680,kf=519,Bf=512,zf=513,Hf=514,fl=515,Gf=516,Vf=517,Lu=518,Iu=519,Wf=35044,fi="300 es",cn=2e3,Dr=2001;function Xf(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Nr(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function qf(){const i=Nr("canvas");return i.style.display="block",i}const dc={};function fc(...i){const t="THREE."+i.shift();console.log(t,...i)}function Du(i){const t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){const e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ct(...i){i=Du(i);const t="THREE."+i.shift();{const e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Kt(...i){i=Du(i);const t="THREE."+i.shift();{const e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function wr(...i){const t=i.join(" ");t in dc||(dc[t]=!0,Ct(...i))}function $f(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}const Yf={[Zo]:Zo,[Qo]:ea,[jo]:jo,[Es]:ta,[Jo]:Jo,[ea]:Qo,[na]:na,[ta]:Es};class yi{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){const n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){const n=this._listeners;if(n===void 0)return;const s=n[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){const e=this._listeners;if(e===void 0)return;const n=e[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const Pe=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],co=Math.PI/180,Na=180/Math.PI;function As(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Pe[i&255]+Pe[i>>8&255]+Pe[i>>16&255]+Pe[i>>24&255]+"-"+Pe[t&255]+Pe[t>>8&255]+"-"+Pe[t>>16&15|64]+Pe[t>>24&255]+"-"+Pe[e&63|128]+Pe[e>>8&255]+"-"+Pe[e>>16&255]+Pe[e>>24&255]+Pe[n&255]+Pe[n>>8&255]+Pe[n>>16&255]+Pe[n>>24&255]).toLowerCase()}function Wt(i,t,e){return Math.max(t,Math.min(e,i))}function Kf(i,t){return(i%t+t)%t}function ho(i,t,e){return(1-e)*i+e*t}function Zf(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function pl(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Jf(i,t){if(t.constructor===Float32Array)return i;const e=pl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function Qf(i,t){if(t.constructor===Float32Array)return i;const e=pl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}class $t{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Ki{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],h=n[s+2],d=n[s+3],u=r[o+0],f=r[o+1],v=r[o+2],S=r[o+3];if(d!==S||l!==u||c!==f||h!==v){let m=l*u+c*f+h*v+d*S;m<0&&(u=-u,f=-f,v=-v,S=-S,m=-m);let p=1-a;if(m<.9995){const M=Math.acos(m),A=Math.sin(M);p=Math.sin(p*M)/A,a=Math.sin(a*M)/A,l=l*p+u*a,c=c*p+f*a,h=h*p+v*a,d=d*p+S*a}else{l=l*p+u*a,c=c*p+f*a,h=h*p+v*a,d=d*p+S*a;const M=1/Math.sqrt(l*l+c*c+h*h+d*d);l*=M,c*=M,h*=M,d*=M}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=d}static multiplyQuaternionsFlat(t,e,n,s,r,o){const a=n[s],l=n[s+1],c=n[s+2],h=n[s+3],d=r[o],u=r[o+1],f=r[o+2],v=r[o+3];return t[e]=a*v+h*d+l*f-c*u,t[e+1]=l*v+h*u+c*d-a*f,t[e+2]=c*v+h*f+a*u-l*d,t[e+3]=h*v-a*d-l*u-c*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),h=a(s/2),d=a(r/2),u=l(n/2),f=l(s/2),v=l(r/2);switch(o){case"XYZ":this._x=u*h*d+c*f*v,this._y=c*f*d-u*h*v,this._z=c*h*v+u*f*d,this._w=c*h*d-u*f*v;break;case"YXZ":this._x=u*h*d+c*f*v,this._y=c*f*d-u*h*v,this._z=c*h*v-u*f*d,this._w=c*h*d+u*f*v;break;case"ZXY":this._x=u*h*d-c*f*v,this._y=c*f*d+u*h*v,this._z=c*h*v+u*f*d,this._w=c*h*d-u*f*v;break;case"ZYX":this._x=u*h*d-c*f*v,this._y=c*f*d+u*h*v,this._z=c*h*v-u*f*d,this._w=c*h*d+u*f*v;break;case"YZX":this._x=u*h*d+c*f*v,this._y=c*f*d+u*h*v,this._z=c*h*v-u*f*d,this._w=c*h*d-u*f*v;break;case"XZY":this._x=u*h*d-c*f*v,this._y=c*f*d-u*h*v,this._z=c*h*v+u*f*d,this._w=c*h*d+u*f*v;break;default:Ct("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],d=e[10],u=n+a+d;if(u>0){const f=.5/Math.sqrt(u+1);this._w=.25/f,this._x=(h-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>d){const f=2*Math.sqrt(1+n-a-d);this._w=(h-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){const f=2*Math.sqrt(1+a-n-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+h)/f}else{const f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=n*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-n*c,this._z=r*h+o*c+n*l-s*a,this._w=o*h-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){const c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+n*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class U{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(pc.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(pc.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),h=2*(a*e-r*s),d=2*(r*n-o*e);return this.x=e+l*c+o*d-a*h,this.y=n+l*h+a*c-r*d,this.z=s+l*d+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return uo.copy(this).projectOnVector(t),this.sub(uo)}reflect(t){return this.sub(uo.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(Wt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const uo=new U,pc=new Ki;class Lt{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){const h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=n,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],h=n[4],d=n[7],u=n[2],f=n[5],v=n[8],S=s[0],m=s[3],p=s[6],M=s[1],A=s[4],E=s[7],R=s[2],b=s[5],g=s[8];return r[0]=o*S+a*M+l*R,r[3]=o*m+a*A+l*b,r[6]=o*p+a*E+l*g,r[1]=c*S+h*M+d*R,r[4]=c*m+h*A+d*b,r[7]=c*p+h*E+d*g,r[2]=u*S+f*M+v*R,r[5]=u*m+f*A+v*b,r[8]=u*p+f*E+v*g,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-n*r*h+n*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=h*o-a*c,u=a*l-h*r,f=c*r-o*l,v=e*d+n*u+s*f;if(v===0)return this.set(0,0,0,0,0,0,0,0,0);const S=1/v;return t[0]=d*S,t[1]=(s*c-h*n)*S,t[2]=(a*n-s*o)*S,t[3]=u*S,t[4]=(h*e-s*l)*S,t[5]=(s*r-a*e)*S,t[6]=f*S,t[7]=(n*l-c*e)*S,t[8]=(o*e-n*r)*S,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return wr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(fo.makeScale(t,e)),this}rotate(t){return wr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(fo.makeRotation(-t)),this}translate(t,e){return wr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(fo.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const fo=new Lt,mc=new Lt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),gc=new Lt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function jf(){const i={enabled:!0,workingColorSpace:Lr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===te&&(s.r=zn(s.r),s.g=zn(s.g),s.b=zn(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===te&&(s.r=zi(s.r),s.g=zi(s.g),s.b=zi(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Nn?Ir:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Lr]:{primaries:t,whitePoint:n,transfer:Ir,toXYZ:mc,fromXYZ:gc,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ye},outputColorSpaceConfig:{drawingBufferColorSpace:Ye}},[Ye]:{primaries:t,whitePoint:n,transfer:te,toXYZ:mc,fromXYZ:gc,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ye}}}),i}const Xt=jf();function zn(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function zi(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}let Ei;class tp{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Ei===void 0&&(Ei=Nr("canvas")),Ei.width=t.width,Ei.height=t.height;const s=Ei.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Ei}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Nr("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=zn(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(zn(e[n]/255)*255):e[n]=zn(e[n]);return{data:e,width:t.width,height:t.height}}else return Ct("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let ep=0;class ml{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ep++}),this.uuid=As(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){const e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(po(s[o].image)):r.push(po(s[o]))}else r=po(s);n.url=r}return e||(t.images[this.uuid]=n),n}}function po(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?tp.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ct("Texture: Unable to serialize Texture."),{})}let np=0;const mo=new U;class Ue extends yi{constructor(t=Ue.DEFAULT_IMAGE,e=Ue.DEFAULT_MAPPING,n=kn,s=kn,r=Ie,o=Qn,a=Qe,l=Ze,c=Ue.DEFAULT_ANISOTROPY,h=Nn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:np++}),this.uuid=As(),this.name="",this.source=new ml(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new $t(0,0),this.repeat=new $t(1,1),this.center=new $t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Lt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(mo).x}get height(){return this.source.getSize(mo).y}get depth(){return this.source.getSize(mo).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(const e in t){const n=t[e];if(n===void 0){Ct(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){Ct(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==yu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Rr:t.x=t.x-Math.floor(t.x);break;case kn:t.x=t.x<0?0:1;break;case ia:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Rr:t.y=t.y-Math.floor(t.y);break;case kn:t.y=t.y<0?0:1;break;case ia:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}Ue.DEFAULT_IMAGE=null;Ue.DEFAULT_MAPPING=yu;Ue.DEFAULT_ANISOTROPY=1;class ce{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r;const l=t.elements,c=l[0],h=l[4],d=l[8],u=l[1],f=l[5],v=l[9],S=l[2],m=l[6],p=l[10];if(Math.abs(h-u)<.01&&Math.abs(d-S)<.01&&Math.abs(v-m)<.01){if(Math.abs(h+u)<.1&&Math.abs(d+S)<.1&&Math.abs(v+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const A=(c+1)/2,E=(f+1)/2,R=(p+1)/2,b=(h+u)/4,g=(d+S)/4,y=(v+m)/4;return A>E&&A>R?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=b/n,r=g/n):E>R?E<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(E),n=b/s,r=y/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=g/r,s=y/r),this.set(n,s,r,e),this}let M=Math.sqrt((m-v)*(m-v)+(d-S)*(d-S)+(u-h)*(u-h));return Math.abs(M)<.001&&(M=1),this.x=(m-v)/M,this.y=(d-S)/M,this.z=(u-h)/M,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(Wt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class ip extends yi{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ie,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new ce(0,0,t,e),this.scissorTest=!1,this.viewport=new ce(0,0,t,e),this.textures=[];const s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Ue({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){const e={minFilter:Ie,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;const s=Object.assign({},t.textures[e].image);this.textures[e].source=new ml(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){const e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}}class un extends ip{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class gl extends Ue{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=me,this.minFilter=me,this.wrapR=kn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class sp extends Ue{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=me,this.minFilter=me,this.wrapR=kn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}}class Zt{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,l,c,h,d,u,f,v,S,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,h,d,u,f,v,S,m)}set(t,e,n,s,r,o,a,l,c,h,d,u,f,v,S,m){const p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=h,p[10]=d,p[14]=u,p[3]=f,p[7]=v,p[11]=S,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Zt().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();const e=this.elements,n=t.elements,s=1/bi.setFromMatrixColumn(t,0).length(),r=1/bi.setFromMatrixColumn(t,1).length(),o=1/bi.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),d=Math.sin(r);if(t.order==="XYZ"){const u=o*h,f=o*d,v=a*h,S=a*d;e[0]=l*h,e[4]=-l*d,e[8]=c,e[1]=f+v*c,e[5]=u-S*c,e[9]=-a*l,e[2]=S-u*c,e[6]=v+f*c,e[10]=o*l}else if(t.order==="YXZ"){const u=l*h,f=l*d,v=c*h,S=c*d;e[0]=u+S*a,e[4]=v*a-f,e[8]=o*c,e[1]=o*d,e[5]=o*h,e[9]=-a,e[2]=f*a-v,e[6]=S+u*a,e[10]=o*l}else if(t.order==="ZXY"){const u=l*h,f=l*d,v=c*h,S=c*d;e[0]=u-S*a,e[4]=-o*d,e[8]=v+f*a,e[1]=f+v*a,e[5]=o*h,e[9]=S-u*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const u=o*h,f=o*d,v=a*h,S=a*d;e[0]=l*h,e[4]=v*c-f,e[8]=u*c+S,e[1]=l*d,e[5]=S*c+u,e[9]=f*c-v,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const u=o*l,f=o*c,v=a*l,S=a*c;e[0]=l*h,e[4]=S-u*d,e[8]=v*d+f,e[1]=d,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=f*d+v,e[10]=u-S*d}else if(t.order==="XZY"){const u=o*l,f=o*c,v=a*l,S=a*c;e[0]=l*h,e[4]=-d,e[8]=c*h,e[1]=u*d+S,e[5]=o*h,e[9]=f*d-v,e[2]=v*d-f,e[6]=a*h,e[10]=S*d+u}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(rp,t,op)}lookAt(t,e,n){const s=this.elements;return Be.subVectors(t,e),Be.lengthSq()===0&&(Be.z=1),Be.normalize(),Wn.crossVectors(n,Be),Wn.lengthSq()===0&&(Math.abs(n.z)===1?Be.x+=1e-4:Be.z+=1e-4,Be.normalize(),Wn.crossVectors(n,Be)),Wn.normalize(),Fs.crossVectors(Be,Wn),s[0]=Wn.x,s[4]=Fs.x,s[8]=Be.x,s[1]=Wn.y,s[5]=Fs.y,s[9]=Be.y,s[2]=Wn.z,s[6]=Fs.z,s[10]=Be.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],h=n[1],d=n[5],u=n[9],f=n[13],v=n[2],S=n[6],m=n[10],p=n[14],M=n[3],A=n[7],E=n[11],R=n[15],b=s[0],g=s[4],y=s[8],k=s[12],L=s[1],D=s[5],z=s[9],q=s[13],P=s[2],W=s[6],Z=s[10],H=s[14],et=s[3],V=s[7],Q=s[11],j=s[15];return r[0]=o*b+a*L+l*P+c*et,r[4]=o*g+a*D+l*W+c*V,r[8]=o*y+a*z+l*Z+c*Q,r[12]=o*k+a*q+l*H+c*j,r[1]=h*b+d*L+u*P+f*et,r[5]=h*g+d*D+u*W+f*V,r[9]=h*y+d*z+u*Z+f*Q,r[13]=h*k+d*q+u*H+f*j,r[2]=v*b+S*L+m*P+p*et,r[6]=v*g+S*D+m*W+p*V,r[10]=v*y+S*z+m*Z+p*Q,r[14]=v*k+S*q+m*H+p*j,r[3]=M*b+A*L+E*P+R*et,r[7]=M*g+A*D+E*W+R*V,r[11]=M*y+A*z+E*Z+R*Q,r[15]=M*k+A*q+E*H+R*j,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],d=t[6],u=t[10],f=t[14],v=t[3],S=t[7],m=t[11],p=t[15],M=l*f-c*u,A=a*f-c*d,E=a*u-l*d,R=o*f-c*h,b=o*u-l*h,g=o*d-a*h;return e*(S*M-m*A+p*E)-n*(v*M-m*R+p*b)+s*(v*A-S*R+p*g)-r*(v*E-S*b+m*g)}determinantAffine(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-n*(r*h-a*l)+s*(r*c-o*l)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],d=t[9],u=t[10],f=t[11],v=t[12],S=t[13],m=t[14],p=t[15],M=e*a-n*o,A=e*l-s*o,E=e*c-r*o,R=n*l-s*a,b=n*c-r*a,g=s*c-r*l,y=h*S-d*v,k=h*m-u*v,L=h*p-f*v,D=d*m-u*S,z=d*p-f*S,q=u*p-f*m,P=M*q-A*z+E*D+R*L-b*k+g*y;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const W=1/P;return t[0]=(a*q-l*z+c*D)*W,t[1]=(s*z-n*q-r*D)*W,t[2]=(S*g-m*b+p*R)*W,t[3]=(u*b-d*g-f*R)*W,t[4]=(l*L-o*q-c*k)*W,t[5]=(e*q-s*L+r*k)*W,t[6]=(m*E-v*g-p*A)*W,t[7]=(h*g-u*E+f*A)*W,t[8]=(o*z-a*L+c*y)*W,t[9]=(n*L-e*z-r*y)*W,t[10]=(v*b-S*E+p*M)*W,t[11]=(d*E-h*b-f*M)*W,t[12]=(a*k-o*D-l*y)*W,t[13]=(e*D-n*k+s*y)*W,t[14]=(S*A-v*R-m*M)*W,t[15]=(h*R-d*A+u*M)*W,this}scale(t){const e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+n,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,d=a+a,u=r*c,f=r*h,v=r*d,S=o*h,m=o*d,p=a*d,M=l*c,A=l*h,E=l*d,R=n.x,b=n.y,g=n.z;return s[0]=(1-(S+p))*R,s[1]=(f+E)*R,s[2]=(v-A)*R,s[3]=0,s[4]=(f-E)*b,s[5]=(1-(u+p))*b,s[6]=(m+M)*b,s[7]=0,s[8]=(v+A)*g,s[9]=(m-M)*g,s[10]=(1-(u+S))*g,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];const r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=bi.set(s[0],s[1],s[2]).length();const a=bi.set(s[4],s[5],s[6]).length(),l=bi.set(s[8],s[9],s[10]).length();r<0&&(o=-o),nn.copy(this);const c=1/o,h=1/a,d=1/l;return nn.elements[0]*=c,nn.elements[1]*=c,nn.elements[2]*=c,nn.elements[4]*=h,nn.elements[5]*=h,nn.elements[6]*=h,nn.elements[8]*=d,nn.elements[9]*=d,nn.elements[10]*=d,e.setFromRotationMatrix(nn),n.x=o,n.y=a,n.z=l,this}makePerspective(t,e,n,s,r,o,a=cn,l=!1){const c=this.elements,h=2*r/(e-t),d=2*r/(n-s),u=(e+t)/(e-t),f=(n+s)/(n-s);let v,S;if(l)v=r/(o-r),S=o*r/(o-r);else if(a===cn)v=-(o+r)/(o-r),S=-2*o*r/(o-r);else if(a===Dr)v=-o/(o-r),S=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=u,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=v,c[14]=S,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=cn,l=!1){const c=this.elements,h=2/(e-t),d=2/(n-s),u=-(e+t)/(e-t),f=-(n+s)/(n-s);let v,S;if(l)v=1/(o-r),S=o/(o-r);else if(a===cn)v=-2/(o-r),S=-(o+r)/(o-r);else if(a===Dr)v=-1/(o-r),S=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=u,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=v,c[14]=S,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const bi=new U,nn=new Zt,rp=new U(0,0,0),op=new U(1,1,1),Wn=new U,Fs=new U,Be=new U,_c=new Zt,vc=new Ki;class xi{constructor(t=0,e=0,n=0,s=xi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],d=s[2],u=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(u,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Wt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(u,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Wt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(u,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Ct("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return _c.makeRotationFromQuaternion(t),this.setFromRotationMatrix(_c,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return vc.setFromEuler(this),this.setFromQuaternion(vc,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}xi.DEFAULT_ORDER="XYZ";class Nu{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let ap=0;const xc=new U,Ti=new Ki,An=new Zt,Os=new U,ts=new U,lp=new U,cp=new Ki,Sc=new U(1,0,0),Mc=new U(0,1,0),wc=new U(0,0,1),yc={type:"added"},hp={type:"removed"},Ai={type:"childadded",child:null},go={type:"childremoved",child:null};class Ge extends yi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:ap++}),this.uuid=As(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Ge.DEFAULT_UP.clone();const t=new U,e=new xi,n=new Ki,s=new U(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Zt},normalMatrix:{value:new Lt}}),this.matrix=new Zt,this.matrixWorld=new Zt,this.matrixAutoUpdate=Ge.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Ge.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Nu,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Ti.setFromAxisAngle(t,e),this.quaternion.multiply(Ti),this}rotateOnWorldAxis(t,e){return Ti.setFromAxisAngle(t,e),this.quaternion.premultiply(Ti),this}rotateX(t){return this.rotateOnAxis(Sc,t)}rotateY(t){return this.rotateOnAxis(Mc,t)}rotateZ(t){return this.rotateOnAxis(wc,t)}translateOnAxis(t,e){return xc.copy(t).applyQuaternion(this.quaternion),this.position.add(xc.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Sc,t)}translateY(t){return this.translateOnAxis(Mc,t)}translateZ(t){return this.translateOnAxis(wc,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(An.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Os.copy(t):Os.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),ts.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?An.lookAt(ts,Os,this.up):An.lookAt(Os,ts,this.up),this.quaternion.setFromRotationMatrix(An),s&&(An.extractRotation(s.matrixWorld),Ti.setFromRotationMatrix(An),this.quaternion.premultiply(Ti.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Kt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(yc),Ai.child=t,this.dispatchEvent(Ai),Ai.child=null):Kt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(hp),go.child=t,this.dispatchEvent(go),go.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),An.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),An.multiply(t.parent.matrixWorld)),t.applyMatrix4(An),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(yc),Ai.child=t,this.dispatchEvent(Ai),Ai.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ts,t,lp),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ts,cp,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);const t=this.pivot;if(t!==null){const e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){const s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){const r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){const d=l[c];r(t.shapes,d)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),d=o(t.shapes),u=o(t.skeletons),f=o(t.animations),v=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),h.length>0&&(n.images=h),d.length>0&&(n.shapes=d),u.length>0&&(n.skeletons=u),f.length>0&&(n.animations=f),v.length>0&&(n.nodes=v)}return n.object=s,n;function o(a){const l=[];for(const c in a){const h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}}Ge.DEFAULT_UP=new U(0,1,0);Ge.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ge.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;class ks extends Ge{constructor(){super(),this.isGroup=!0,this.type="Group"}}const up={type:"move"};class _o{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ks,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ks,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new U,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new U),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ks,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new U,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new U,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const S of t.hand.values()){const m=e.getJointPose(S,n),p=this._getHandJoint(c,S);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const h=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],u=h.position.distanceTo(d.position),f=.02,v=.005;c.inputState.pinching&&u>f+v?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&u<=f-v&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(up)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new ks;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}const Uu={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Xn={h:0,s:0,l:0},Bs={h:0,s:0,l:0};function vo(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class zt{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ye){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Xt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Xt.workingColorSpace){return this.r=t,this.g=e,this.b=n,Xt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Xt.workingColorSpace){if(t=Kf(t,1),e=Wt(e,0,1),n=Wt(n,0,1),e===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=vo(o,r,t+1/3),this.g=vo(o,r,t),this.b=vo(o,r,t-1/3)}return Xt.colorSpaceToWorking(this,s),this}setStyle(t,e=Ye){function n(r){r!==void 0&&parseFloat(r)<1&&Ct("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Ct("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Ct("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ye){const n=Uu[t.toLowerCase()];return n!==void 0?this.setHex(n,e):Ct("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=zn(t.r),this.g=zn(t.g),this.b=zn(t.b),this}copyLinearToSRGB(t){return this.r=zi(t.r),this.g=zi(t.g),this.b=zi(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ye){return Xt.workingToColorSpace(Le.copy(this),t),Math.round(Wt(Le.r*255,0,255))*65536+Math.round(Wt(Le.g*255,0,255))*256+Math.round(Wt(Le.b*255,0,255))}getHexString(t=Ye){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Xt.workingColorSpace){Xt.workingToColorSpace(Le.copy(this),e);const n=Le.r,s=Le.g,r=Le.b,o=Math.max(n,s,r),a=Math.min(n,s,r);let l,c;const h=(a+o)/2;if(a===o)l=0,c=0;else{const d=o-a;switch(c=h<=.5?d/(o+a):d/(2-o-a),o){case n:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-n)/d+2;break;case r:l=(n-s)/d+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Xt.workingColorSpace){return Xt.workingToColorSpace(Le.copy(this),e),t.r=Le.r,t.g=Le.g,t.b=Le.b,t}getStyle(t=Ye){Xt.workingToColorSpace(Le.copy(this),t);const e=Le.r,n=Le.g,s=Le.b;return t!==Ye?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(Xn),this.setHSL(Xn.h+t,Xn.s+e,Xn.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Xn),t.getHSL(Bs);const n=ho(Xn.h,Bs.h,e),s=ho(Xn.s,Bs.s,e),r=ho(Xn.l,Bs.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const Le=new zt;zt.NAMES=Uu;class Ms extends Ge{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new xi,this.environmentIntensity=1,this.environmentRotation=new xi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}}const sn=new U,Rn=new U,xo=new U,Cn=new U,Ri=new U,Ci=new U,Ec=new U,So=new U,Mo=new U,wo=new U,yo=new ce,Eo=new ce,bo=new ce;class ln{constructor(t=new U,e=new U,n=new U){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),sn.subVectors(t,e),s.cross(sn);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){sn.subVectors(s,e),Rn.subVectors(n,e),xo.subVectors(t,e);const o=sn.dot(sn),a=sn.dot(Rn),l=sn.dot(xo),c=Rn.dot(Rn),h=Rn.dot(xo),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;const u=1/d,f=(c*l-a*h)*u,v=(o*h-a*l)*u;return r.set(1-f-v,v,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Cn)===null?!1:Cn.x>=0&&Cn.y>=0&&Cn.x+Cn.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Cn)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Cn.x),l.addScaledVector(o,Cn.y),l.addScaledVector(a,Cn.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return yo.setScalar(0),Eo.setScalar(0),bo.setScalar(0),yo.fromBufferAttribute(t,e),Eo.fromBufferAttribute(t,n),bo.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(yo,r.x),o.addScaledVector(Eo,r.y),o.addScaledVector(bo,r.z),o}static isFrontFacing(t,e,n,s){return sn.subVectors(n,e),Rn.subVectors(t,e),sn.cross(Rn).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return sn.subVectors(this.c,this.b),Rn.subVectors(this.a,this.b),sn.cross(Rn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return ln.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return ln.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return ln.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return ln.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return ln.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,r=this.c;let o,a;Ri.subVectors(s,n),Ci.subVectors(r,n),So.subVectors(t,n);const l=Ri.dot(So),c=Ci.dot(So);if(l<=0&&c<=0)return e.copy(n);Mo.subVectors(t,s);const h=Ri.dot(Mo),d=Ci.dot(Mo);if(h>=0&&d<=h)return e.copy(s);const u=l*d-h*c;if(u<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(n).addScaledVector(Ri,o);wo.subVectors(t,r);const f=Ri.dot(wo),v=Ci.dot(wo);if(v>=0&&f<=v)return e.copy(r);const S=f*c-l*v;if(S<=0&&c>=0&&v<=0)return a=c/(c-v),e.copy(n).addScaledVector(Ci,a);const m=h*v-f*d;if(m<=0&&d-h>=0&&f-v>=0)return Ec.subVectors(r,s),a=(d-h)/(d-h+(f-v)),e.copy(s).addScaledVector(Ec,a);const p=1/(m+S+u);return o=S*p,a=u*p,e.copy(n).addScaledVector(Ri,o).addScaledVector(Ci,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}class Rs{constructor(t=new U(1/0,1/0,1/0),e=new U(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(rn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(rn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=rn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,rn):rn.fromBufferAttribute(r,o),rn.applyMatrix4(t.matrixWorld),this.expandByPoint(rn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),zs.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),zs.copy(n.boundingBox)),zs.applyMatrix4(t.matrixWorld),this.union(zs)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,rn),rn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(es),Hs.subVectors(this.max,es),Pi.subVectors(t.a,es),Li.subVectors(t.b,es),Ii.subVectors(t.c,es),qn.subVectors(Li,Pi),$n.subVectors(Ii,Li),ci.subVectors(Pi,Ii);let e=[0,-qn.z,qn.y,0,-$n.z,$n.y,0,-ci.z,ci.y,qn.z,0,-qn.x,$n.z,0,-$n.x,ci.z,0,-ci.x,-qn.y,qn.x,0,-$n.y,$n.x,0,-ci.y,ci.x,0];return!To(e,Pi,Li,Ii,Hs)||(e=[1,0,0,0,1,0,0,0,1],!To(e,Pi,Li,Ii,Hs))?!1:(Gs.crossVectors(qn,$n),e=[Gs.x,Gs.y,Gs.z],To(e,Pi,Li,Ii,Hs))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,rn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(rn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Pn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Pn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Pn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Pn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Pn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Pn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Pn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Pn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Pn),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}}const Pn=[new U,new U,new U,new U,new U,new U,new U,new U],rn=new U,zs=new Rs,Pi=new U,Li=new U,Ii=new U,qn=new U,$n=new U,ci=new U,es=new U,Hs=new U,Gs=new U,hi=new U;function To(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){hi.fromArray(i,r);const a=s.x*Math.abs(hi.x)+s.y*Math.abs(hi.y)+s.z*Math.abs(hi.z),l=t.dot(hi),c=e.dot(hi),h=n.dot(hi);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}const Un=dp();function dp(){const i=new ArrayBuffer(4),t=new Float32Array(i),e=new Uint32Array(i),n=new Uint32Array(512),s=new Uint32Array(512);for(let l=0;l<256;++l){const c=l-127;c<-27?(n[l]=0,n[l|256]=32768,s[l]=24,s[l|256]=24):c<-14?(n[l]=1024>>-c-14,n[l|256]=1024>>-c-14|32768,s[l]=-c-1,s[l|256]=-c-1):c<=15?(n[l]=c+15<<10,n[l|256]=c+15<<10|32768,s[l]=13,s[l|256]=13):c<128?(n[l]=31744,n[l|256]=64512,s[l]=24,s[l|256]=24):(n[l]=31744,n[l|256]=64512,s[l]=13,s[l|256]=13)}const r=new Uint32Array(2048),o=new Uint32Array(64),a=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,h=0;for(;(c&8388608)===0;)c<<=1,h-=8388608;c&=-8388609,h+=947912704,r[l]=c|h}for(let l=1024;l<2048;++l)r[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(a[l]=1024);return{floatView:t,uint32View:e,baseTable:n,shiftTable:s,mantissaTable:r,exponentTable:o,offsetTable:a}}function fp(i){Math.abs(i)>65504&&Ct("DataUtils.toHalfFloat(): Value out of range."),i=Wt(i,-65504,65504),Un.floatView[0]=i;const t=Un.uint32View[0],e=t>>23&511;return Un.baseTable[e]+((t&8388607)>>Un.shiftTable[e])}function pp(i){const t=i>>10;return Un.uint32View[0]=Un.mantissaTable[Un.offsetTable[t]+(i&1023)]+Un.exponentTable[t],Un.floatView[0]}class Fu{static toHalfFloat(t){return fp(t)}static fromHalfFloat(t){return pp(t)}}const fe=new U,Vs=new $t;let mp=0;class je extends yi{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:mp++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Wf,this.updateRanges=[],this.gpuType=Je,this.version=0,this._normalizationScale=t!==void 0?pl(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Vs.fromBufferAttribute(this,e),Vs.applyMatrix3(t),this.setXY(e,Vs.x,Vs.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)fe.fromBufferAttribute(this,e),fe.applyMatrix3(t),this.setXYZ(e,fe.x,fe.y,fe.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)fe.fromBufferAttribute(this,e),fe.applyMatrix4(t),this.setXYZ(e,fe.x,fe.y,fe.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)fe.fromBufferAttribute(this,e),fe.applyNormalMatrix(t),this.setXYZ(e,fe.x,fe.y,fe.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)fe.fromBufferAttribute(this,e),fe.transformDirection(t),this.setXYZ(e,fe.x,fe.y,fe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){const e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Jf(t,this.array)}_normalize(t){const e=this._normalizationScale;return e!==void 0?Math.round(t*e):Qf(t,this.array)}}class Ou extends je{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class ku extends je{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class Hn extends je{constructor(t,e,n){super(new Float32Array(t),e,n)}}const gp=new Rs,ns=new U,Ao=new U;class _l{constructor(t=new U,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):gp.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ns.subVectors(t,this.center);const e=ns.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(ns,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Ao.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ns.copy(t.center).add(Ao)),this.expandByPoint(ns.copy(t.center).sub(Ao))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}}let _p=0;const $e=new Zt,Ro=new Ge,Di=new U,ze=new Rs,is=new Rs,ye=new U;class bn extends yi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:_p++}),this.uuid=As(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Xf(t)?ku:Ou)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new Lt().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return $e.makeRotationFromQuaternion(t),this.applyMatrix4($e),this}rotateX(t){return $e.makeRotationX(t),this.applyMatrix4($e),this}rotateY(t){return $e.makeRotationY(t),this.applyMatrix4($e),this}rotateZ(t){return $e.makeRotationZ(t),this.applyMatrix4($e),this}translate(t,e,n){return $e.makeTranslation(t,e,n),this.applyMatrix4($e),this}scale(t,e,n){return $e.makeScale(t,e,n),this.applyMatrix4($e),this}lookAt(t){return Ro.lookAt(t),Ro.updateMatrix(),this.applyMatrix4(Ro.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Di).negate(),this.translate(Di.x,Di.y,Di.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Hn(n,3))}else{const n=Math.min(t.length,e.count);for(let s=0;s<n;s++){const r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Ct("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Rs);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Kt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new U(-1/0,-1/0,-1/0),new U(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const r=e[n];ze.setFromBufferAttribute(r),this.morphTargetsRelative?(ye.addVectors(this.boundingBox.min,ze.min),this.boundingBox.expandByPoint(ye),ye.addVectors(this.boundingBox.max,ze.max),this.boundingBox.expandByPoint(ye)):(this.boundingBox.expandByPoint(ze.min),this.boundingBox.expandByPoint(ze.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Kt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new _l);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Kt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new U,1/0);return}if(t){const n=this.boundingSphere.center;if(ze.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];is.setFromBufferAttribute(a),this.morphTargetsRelative?(ye.addVectors(ze.min,is.min),ze.expandByPoint(ye),ye.addVectors(ze.max,is.max),ze.expandByPoint(ye)):(ze.expandByPoint(is.min),ze.expandByPoint(is.max))}ze.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)ye.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(ye));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)ye.fromBufferAttribute(a,c),l&&(Di.fromBufferAttribute(t,c),ye.add(Di)),s=Math.max(s,n.distanceToSquared(ye))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Kt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Kt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,r=e.uv;let o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new je(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));const a=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)a[k]=new U,l[k]=new U;const h=new U,d=new U,u=new U,f=new $t,v=new $t,S=new $t,m=new U,p=new U;function M(k,L,D){c[k]=c[L]=c[D]=1,h.fromBufferAttribute(n,k),d.fromBufferAttribute(n,L),u.fromBufferAttribute(n,D),f.fromBufferAttribute(r,k),v.fromBufferAttribute(r,L),S.fromBufferAttribute(r,D),d.sub(h),u.sub(h),v.sub(f),S.sub(f);const z=1/(v.x*S.y-S.x*v.y);isFinite(z)&&(m.copy(d).multiplyScalar(S.y).addScaledVector(u,-v.y).multiplyScalar(z),p.copy(u).multiplyScalar(v.x).addScaledVector(d,-S.x).multiplyScalar(z),a[k].add(m),a[L].add(m),a[D].add(m),l[k].add(p),l[L].add(p),l[D].add(p))}let A=this.groups;A.length===0&&(A=[{start:0,count:t.count}]);for(let k=0,L=A.length;k<L;++k){const D=A[k],z=D.start,q=D.count;for(let P=z,W=z+q;P<W;P+=3)M(t.getX(P+0),t.getX(P+1),t.getX(P+2))}const E=new U,R=new U,b=new U,g=new U;function y(k){b.fromBufferAttribute(s,k),g.copy(b);const L=a[k];E.copy(L),E.sub(b.multiplyScalar(b.dot(L))).normalize(),R.crossVectors(g,L);const z=R.dot(l[k])<0?-1:1;o.setXYZW(k,E.x,E.y,E.z,z)}for(let k=0,L=n.count;k<L;++k)c[k]&&y(k);this._transformed=!0}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new je(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let u=0,f=n.count;u<f;u++)n.setXYZ(u,0,0,0);const s=new U,r=new U,o=new U,a=new U,l=new U,c=new U,h=new U,d=new U;if(t)for(let u=0,f=t.count;u<f;u+=3){const v=t.getX(u+0),S=t.getX(u+1),m=t.getX(u+2);s.fromBufferAttribute(e,v),r.fromBufferAttribute(e,S),o.fromBufferAttribute(e,m),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),a.fromBufferAttribute(n,v),l.fromBufferAttribute(n,S),c.fromBufferAttribute(n,m),a.add(h),l.add(h),c.add(h),n.setXYZ(v,a.x,a.y,a.z),n.setXYZ(S,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let u=0,f=e.count;u<f;u+=3)s.fromBufferAttribute(e,u+0),r.fromBufferAttribute(e,u+1),o.fromBufferAttribute(e,u+2),h.subVectors(o,r),d.subVectors(s,r),h.cross(d),n.setXYZ(u+0,h.x,h.y,h.z),n.setXYZ(u+1,h.x,h.y,h.z),n.setXYZ(u+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)ye.fromBufferAttribute(t,e),ye.normalize(),t.setXYZ(e,ye.x,ye.y,ye.z)}toNonIndexed(){function t(a,l){const c=a.array,h=a.itemSize,d=a.normalized,u=new c.constructor(l.length*h);let f=0,v=0;for(let S=0,m=l.length;S<m;S++){a.isInterleavedBufferAttribute?f=l[S]*a.data.stride+a.offset:f=l[S]*h;for(let p=0;p<h;p++)u[v++]=c[f++]}return new je(u,h,d)}if(this.index===null)return Ct("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new bn,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,n);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let h=0,d=c.length;h<d;h++){const u=c[h],f=t(u,n);l.push(f)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],h=[];for(let d=0,u=c.length;d<u;d++){const f=c[d];h.push(f.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone());const s=t.attributes;for(const c in s){const h=s[c];this.setAttribute(c,h.clone(e))}const r=t.morphAttributes;for(const c in r){const h=[],d=r[c];for(let u=0,f=d.length;u<f;u++)h.push(d[u].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,h=o.length;c<h;c++){const d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Co=new U,vp=new U,xp=new Lt;class Kn{constructor(t=new U(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=Co.subVectors(n,e).cross(vp.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){const s=t.delta(Co),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||xp.getNormalMatrix(t),s=this.coplanarPoint(Co).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}}let Sp=0;class Yr extends yi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Sp++}),this.uuid=As(),this.name="",this.type="Material",this.blending=Ss,this.side=ei,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=fu,this.blendDst=pu,this.blendEquation=Fi,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new zt(0,0,0),this.blendAlpha=0,this.depthFunc=Es,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=kf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=lo,this.stencilZFail=lo,this.stencilZPass=lo,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){Ct(`Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){Ct(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new zt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Kn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new $t().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new $t().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}}const Ln=new U,Po=new U,Ws=new U,Xs=new U;class Mp{constructor(t=new U,e=new U(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ln)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Ln.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ln.copy(this.origin).addScaledVector(this.direction,e),Ln.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Po.copy(t).add(e).multiplyScalar(.5),Ws.copy(e).sub(t).normalize(),Xs.copy(this.origin).sub(Po);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Ws),a=Xs.dot(this.direction),l=-Xs.dot(Ws),c=Xs.lengthSq(),h=Math.abs(1-o*o);let d,u,f,v;if(h>0)if(d=o*l-a,u=o*a-l,v=r*h,d>=0)if(u>=-v)if(u<=v){const S=1/h;d*=S,u*=S,f=d*(d+o*u+2*a)+u*(o*d+u+2*l)+c}else u=r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u=-r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;else u<=-v?(d=Math.max(0,-(-o*r+a)),u=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c):u<=v?(d=0,u=Math.min(Math.max(-r,-l),r),f=u*(u+2*l)+c):(d=Math.max(0,-(o*r+a)),u=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+u*(u+2*l)+c);else u=o>0?-r:r,d=Math.max(0,-(o*u+a)),f=-d*d+u*(u+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Po).addScaledVector(Ws,u),f}intersectSphere(t,e){if(t.radius<0)return null;Ln.subVectors(t.center,this.origin);const n=Ln.dot(this.direction),s=Ln.dot(Ln)-n*n,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l;const c=1/this.direction.x,h=1/this.direction.y,d=1/this.direction.z,u=this.origin;return c>=0?(n=(t.min.x-u.x)*c,s=(t.max.x-u.x)*c):(n=(t.max.x-u.x)*c,s=(t.min.x-u.x)*c),h>=0?(r=(t.min.y-u.y)*h,o=(t.max.y-u.y)*h):(r=(t.max.y-u.y)*h,o=(t.min.y-u.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(t.min.z-u.z)*d,l=(t.max.z-u.z)*d):(a=(t.max.z-u.z)*d,l=(t.min.z-u.z)*d),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ln)!==null}intersectTriangle(t,e,n,s,r){const o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,d=t.x-o.x,u=t.y-o.y,f=t.z-o.z,v=e.x-o.x,S=e.y-o.y,m=e.z-o.z,p=n.x-o.x,M=n.y-o.y,A=n.z-o.z,E=Math.abs(l),R=Math.abs(c),b=Math.abs(h);let g,y,k,L,D,z,q,P,W,Z,H,et;if(E>=R&&E>=b?(k=l,z=d,W=v,et=p,l>=0?(g=c,y=h,L=u,D=f,q=S,P=m,Z=M,H=A):(g=h,y=c,L=f,D=u,q=m,P=S,Z=A,H=M)):R>=b?(k=c,z=u,W=S,et=M,c>=0?(g=h,y=l,L=f,D=d,q=m,P=v,Z=A,H=p):(g=l,y=h,L=d,D=f,q=v,P=m,Z=p,H=A)):(k=h,z=f,W=m,et=A,h>=0?(g=l,y=c,L=d,D=u,q=v,P=S,Z=p,H=M):(g=c,y=l,L=u,D=d,q=S,P=v,Z=M,H=p)),k===0)return null;const V=g/k,Q=y/k,j=1/k,wt=L-V*z,It=D-Q*z,Y=q-V*W,mt=P-Q*W,xt=Z-V*et,Tt=H-Q*et,gt=xt*mt-Tt*Y,Nt=wt*Tt-It*xt,ue=Y*It-mt*wt;if(s){if(gt<0||Nt<0||ue<0)return null}else if((gt<0||Nt<0||ue<0)&&(gt>0||Nt>0||ue>0))return null;const Rt=gt+Nt+ue;if(Rt===0)return null;const Qt=j*(gt*z+Nt*W+ue*et);return(Rt>0?Qt<0:Qt>0)?null:this.at(Qt/Rt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class wp extends Yr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new xi,this.combine=mu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const bc=new Zt,ui=new Mp,qs=new _l,Tc=new U,$s=new U,Ys=new U,Ks=new U,Lo=new U,Zs=new U,Ac=new U,Js=new U;class yn extends Ge{constructor(t=new bn,e=new wp){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){Zs.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const h=a[l],d=r[l];h!==0&&(Lo.fromBufferAttribute(d,t),o?Zs.addScaledVector(Lo,h):Zs.addScaledVector(Lo.sub(e),h))}e.add(Zs)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),qs.copy(n.boundingSphere),qs.applyMatrix4(r),ui.copy(t.ray).recast(t.near),!(qs.containsPoint(ui.origin)===!1&&(ui.intersectSphere(qs,Tc)===null||ui.origin.distanceToSquared(Tc)>(t.far-t.near)**2))&&(bc.copy(r).invert(),ui.copy(t.ray).applyMatrix4(bc),!(n.boundingBox!==null&&ui.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,ui)))}_computeIntersections(t,e,n){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,d=r.attributes.normal,u=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let v=0,S=u.length;v<S;v++){const m=u[v],p=o[m.materialIndex],M=Math.max(m.start,f.start),A=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let E=M,R=A;E<R;E+=3){const b=a.getX(E),g=a.getX(E+1),y=a.getX(E+2);s=Qs(this,p,t,n,c,h,d,b,g,y),s&&(s.faceIndex=Math.floor(E/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const v=Math.max(0,f.start),S=Math.min(a.count,f.start+f.count);for(let m=v,p=S;m<p;m+=3){const M=a.getX(m),A=a.getX(m+1),E=a.getX(m+2);s=Qs(this,o,t,n,c,h,d,M,A,E),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let v=0,S=u.length;v<S;v++){const m=u[v],p=o[m.materialIndex],M=Math.max(m.start,f.start),A=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let E=M,R=A;E<R;E+=3){const b=E,g=E+1,y=E+2;s=Qs(this,p,t,n,c,h,d,b,g,y),s&&(s.faceIndex=Math.floor(E/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const v=Math.max(0,f.start),S=Math.min(l.count,f.start+f.count);for(let m=v,p=S;m<p;m+=3){const M=m,A=m+1,E=m+2;s=Qs(this,o,t,n,c,h,d,M,A,E),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function yp(i,t,e,n,s,r,o,a){let l;if(t.side===ke?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===ei,a),l===null)return null;Js.copy(a),Js.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(Js);return c<e.near||c>e.far?null:{distance:c,point:Js.clone(),object:i}}function Qs(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,$s),i.getVertexPosition(l,Ys),i.getVertexPosition(c,Ks);const h=yp(i,t,e,n,$s,Ys,Ks,Ac);if(h){const d=new U;ln.getBarycoord(Ac,$s,Ys,Ks,d),s&&(h.uv=ln.getInterpolatedAttribute(s,a,l,c,d,new $t)),r&&(h.uv1=ln.getInterpolatedAttribute(r,a,l,c,d,new $t)),o&&(h.normal=ln.getInterpolatedAttribute(o,a,l,c,d,new U),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));const u={a,b:l,c,normal:new U,materialIndex:0};ln.getNormal($s,Ys,Ks,u.normal),h.face=u,h.barycoord=d}return h}class Kr extends Ue{constructor(t=null,e=1,n=1,s,r,o,a,l,c=me,h=me,d,u){super(null,o,a,l,c,h,s,r,d,u),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const di=new _l,Ep=new $t(.5,.5),js=new U;class Ur{constructor(t=new Kn,e=new Kn,n=new Kn,s=new Kn,r=new Kn,o=new Kn){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=cn,n=!1){const s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],d=r[5],u=r[6],f=r[7],v=r[8],S=r[9],m=r[10],p=r[11],M=r[12],A=r[13],E=r[14],R=r[15];if(s[0].setComponents(c-o,f-h,p-v,R-M).normalize(),s[1].setComponents(c+o,f+h,p+v,R+M).normalize(),s[2].setComponents(c+a,f+d,p+S,R+A).normalize(),s[3].setComponents(c-a,f-d,p-S,R-A).normalize(),n)s[4].setComponents(l,u,m,E).normalize(),s[5].setComponents(c-l,f-u,p-m,R-E).normalize();else if(s[4].setComponents(c-l,f-u,p-m,R-E).normalize(),e===cn)s[5].setComponents(c+l,f+u,p+m,R+E).normalize();else if(e===Dr)s[5].setComponents(l,u,m,E).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),di.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),di.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(di)}intersectsSprite(t){di.center.set(0,0,0);const e=Ep.distanceTo(t.center);return di.radius=.7071067811865476+e,di.applyMatrix4(t.matrixWorld),this.intersectsSphere(di)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(js.x=s.normal.x>0?t.max.x:t.min.x,js.y=s.normal.y>0?t.max.y:t.min.y,js.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(js)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}const Rc=new Zt;class vl{constructor(){this.coordinateSystem=cn,this._frustums=[],this._count=0}setFromArrayCamera(t){const e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){const r=e[s];Rc.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Ur),n[s].setFromProjectionMatrix(Rc,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){const e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;const e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ur),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new vl().copy(this)}}class Bu extends Ue{constructor(t=[],e=Vi,n,s,r,o,a,l,c,h){super(t,e,n,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class Si extends Ue{constructor(t,e,n=tn,s,r,o,a=me,l=me,c,h=ni,d=1){if(h!==ni&&h!==jn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const u={width:t,height:e,depth:d};super(u,s,r,o,a,l,h,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new ml(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}}class zu extends Si{constructor(t,e=tn,n=Vi,s,r,o=me,a=me,l,c=ni){const h={width:t,height:t,depth:1},d=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}}class Hu extends Ue{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}}class Cs extends bn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],h=[],d=[];let u=0,f=0;v("z","y","x",-1,-1,n,e,t,o,r,0),v("z","y","x",1,-1,n,e,-t,o,r,1),v("x","z","y",1,1,t,n,e,s,o,2),v("x","z","y",1,-1,t,n,-e,s,o,3),v("x","y","z",1,-1,t,e,n,s,r,4),v("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Hn(c,3)),this.setAttribute("normal",new Hn(h,3)),this.setAttribute("uv",new Hn(d,2));function v(S,m,p,M,A,E,R,b,g,y,k){const L=E/g,D=R/y,z=E/2,q=R/2,P=b/2,W=g+1,Z=y+1;let H=0,et=0;const V=new U;for(let Q=0;Q<Z;Q++){const j=Q*D-q;for(let wt=0;wt<W;wt++){const It=wt*L-z;V[S]=It*M,V[m]=j*A,V[p]=P,c.push(V.x,V.y,V.z),V[S]=0,V[m]=0,V[p]=b>0?1:-1,h.push(V.x,V.y,V.z),d.push(wt/g),d.push(1-Q/y),H+=1}}for(let Q=0;Q<y;Q++)for(let j=0;j<g;j++){const wt=u+j+W*Q,It=u+j+W*(Q+1),Y=u+(j+1)+W*(Q+1),mt=u+(j+1)+W*Q;l.push(wt,It,mt),l.push(It,Y,mt),et+=6}a.addGroup(f,et,k),f+=et,u+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Cs(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}class Zr extends bn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,h=l+1,d=t/a,u=e/l,f=[],v=[],S=[],m=[];for(let p=0;p<h;p++){const M=p*u-o;for(let A=0;A<c;A++){const E=A*d-r;v.push(E,-M,0),S.push(0,0,1),m.push(A/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let M=0;M<a;M++){const A=M+c*p,E=M+c*(p+1),R=M+1+c*(p+1),b=M+1+c*p;f.push(A,E,b),f.push(E,R,b)}this.setIndex(f),this.setAttribute("position",new Hn(v,3)),this.setAttribute("normal",new Hn(S,3)),this.setAttribute("uv",new Hn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Zr(t.width,t.height,t.widthSegments,t.heightSegments)}}function Xi(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];if(Cc(s))s.isRenderTargetTexture?(Ct("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(Cc(s[0])){const r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function Ne(i){const t={};for(let e=0;e<i.length;e++){const n=Xi(i[e]);for(const s in n)t[s]=n[s]}return t}function Cc(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function bp(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Gu(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Xt.workingColorSpace}const Tp={clone:Xi,merge:Ne};var Ap=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Rp=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class Mi extends Yr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ap,this.fragmentShader=Rp,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Xi(t.uniforms),this.uniformsGroups=bp(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(const n in t.uniforms){const s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new zt().setHex(s.value);break;case"v2":this.uniforms[n].value=new $t().fromArray(s.value);break;case"v3":this.uniforms[n].value=new U().fromArray(s.value);break;case"v4":this.uniforms[n].value=new ce().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Lt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Zt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(const n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}}class ki extends Mi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}}class Cp extends Yr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ff,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class Pp extends Yr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}const tr=new U,er=new Ki,pn=new U;class Vu extends Ge{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Zt,this.projectionMatrix=new Zt,this.projectionMatrixInverse=new Zt,this.coordinateSystem=cn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(tr,er,pn),pn.x===1&&pn.y===1&&pn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tr,er,pn.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(tr,er,pn),pn.x===1&&pn.y===1&&pn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tr,er,pn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}}const Yn=new U,Pc=new $t,Lc=new $t;class an extends Vu{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=Na*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(co*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Na*2*Math.atan(Math.tan(co*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Yn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Yn.x,Yn.y).multiplyScalar(-t/Yn.z),Yn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Yn.x,Yn.y).multiplyScalar(-t/Yn.z)}getViewSize(t,e){return this.getViewBounds(t,Pc,Lc),e.subVectors(Lc,Pc)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(co*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}class Lp extends Vu{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}const Ni=-90,Ui=1;class Ua extends Ge{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new an(Ni,Ui,t,e);s.layers=this.layers,this.add(s);const r=new an(Ni,Ui,t,e);r.layers=this.layers,this.add(r);const o=new an(Ni,Ui,t,e);o.layers=this.layers,this.add(o);const a=new an(Ni,Ui,t,e);a.layers=this.layers,this.add(a);const l=new an(Ni,Ui,t,e);l.layers=this.layers,this.add(l);const c=new an(Ni,Ui,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===cn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Dr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,h]=this.children,d=t.getRenderTarget(),u=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),v=t.xr.enabled;t.xr.enabled=!1;const S=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),n.texture.mipmapsAutoUpdate=S,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(d,u,f),t.xr.enabled=v,n.texture.needsPMREMUpdate=!0}}class Ip extends an{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}}function Ic(i,t,e,n){const s=Dp(n);switch(e){case Ru:return i*t;case Pu:return i*t/s.components*s.byteLength;case ul:return i*t/s.components*s.byteLength;case ii:return i*t*2/s.components*s.byteLength;case $r:return i*t*2/s.components*s.byteLength;case Cu:return i*t*3/s.components*s.byteLength;case Qe:return i*t*4/s.components*s.byteLength;case dl:return i*t*4/s.components*s.byteLength;case vr:case xr:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Sr:case Mr:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ra:case aa:return Math.max(i,16)*Math.max(t,8)/4;case sa:case oa:return Math.max(i,8)*Math.max(t,8)/2;case la:case ca:case ua:case da:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case ha:case Cr:case fa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case pa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case ma:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case ga:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case _a:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case va:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case xa:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Sa:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Ma:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case wa:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case ya:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Ea:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case ba:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Ta:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Aa:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Ra:case Ca:case Pa:return Math.ceil(i/4)*Math.ceil(t/4)*16;case La:case Ia:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Pr:case Da:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Dp(i){switch(i){case Ze:case Eu:return{byteLength:1,components:1};case Ts:case bu:case dn:return{byteLength:2,components:1};case cl:case hl:return{byteLength:2,components:4};case tn:case ll:case Je:return{byteLength:4,components:1};case Tu:case Au:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:al}}));typeof window<"u"&&(window.__THREE__?Ct("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=al);/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Wu(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function Np(i){const t=new WeakMap;function e(a,l){const c=a.array,h=a.usage,d=c.byteLength,u=i.createBuffer();i.bindBuffer(l,u),i.bufferData(l,c,h),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:u,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,l,c){const h=l.array,d=l.updateRanges;if(i.bindBuffer(c,a),d.length===0)i.bufferSubData(c,0,h);else{d.sort((f,v)=>f.start-v.start);let u=0;for(let f=1;f<d.length;f++){const v=d[u],S=d[f];S.start<=v.start+v.count+1?v.count=Math.max(v.count,S.start+S.count-v.start):(++u,d[u]=S)}d.length=u+1;for(let f=0,v=d.length;f<v;f++){const S=d[f];i.bufferSubData(c,S.start*h.BYTES_PER_ELEMENT,h,S.start,S.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Up=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Fp=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Op=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,kp=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Bp=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,zp=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Hp=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Gp=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Vp=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Wp=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Xp=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,qp=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,$p=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Yp=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Kp=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Zp=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Jp=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Qp=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,jp=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,tm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,em=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,nm=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,im=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,sm=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,rm=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,om=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,am=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,lm=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,cm=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,hm="gl_FragColor = linearToOutputTexel( gl_FragColor );",um=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,dm=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,fm=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,pm=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,mm=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,gm=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,_m=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,vm=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,xm=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Sm=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Mm=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,wm=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,ym=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Em=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,bm=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Tm=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Am=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Rm=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Cm=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Pm=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Lm=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Im=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Dm=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Nm=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Um=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Fm=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Om=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,km=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Bm=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,zm=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Hm=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Gm=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Vm=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Wm=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Xm=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,qm=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,$m=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ym=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Km=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Zm=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Jm=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Qm=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,jm=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,tg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,eg=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ng=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,ig=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,sg=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,rg=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,og=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,ag=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,lg=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,cg=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,hg=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ug=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,dg=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,fg=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,pg=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,mg=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,gg=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,_g=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,vg=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,xg=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Sg=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Mg=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,wg=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,yg=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Eg=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,bg=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Tg=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Ag=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Rg=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Cg=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Pg=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Lg=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Ig=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Dg=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const Ng=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Ug=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Fg=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Og=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,kg=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Bg=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zg=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Hg=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Gg=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Vg=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Wg=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Xg=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qg=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,$g=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Yg=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,Kg=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zg=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Jg=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Qg=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,jg=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,t0=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,e0=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,n0=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,i0=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,s0=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,r0=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,o0=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,a0=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,l0=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,c0=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,h0=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,u0=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,d0=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,f0=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,kt={alphahash_fragment:Up,alphahash_pars_fragment:Fp,alphamap_fragment:Op,alphamap_pars_fragment:kp,alphatest_fragment:Bp,alphatest_pars_fragment:zp,aomap_fragment:Hp,aomap_pars_fragment:Gp,batching_pars_vertex:Vp,batching_vertex:Wp,begin_vertex:Xp,beginnormal_vertex:qp,bsdfs:$p,iridescence_fragment:Yp,bumpmap_pars_fragment:Kp,clipping_planes_fragment:Zp,clipping_planes_pars_fragment:Jp,clipping_planes_pars_vertex:Qp,clipping_planes_vertex:jp,color_fragment:tm,color_pars_fragment:em,color_pars_vertex:nm,color_vertex:im,common:sm,defaultnormal_vertex:rm,displacementmap_pars_vertex:om,displacementmap_vertex:am,emissivemap_fragment:lm,emissivemap_pars_fragment:cm,colorspace_fragment:hm,colorspace_pars_fragment:um,envmap_fragment:dm,envmap_common_pars_fragment:fm,envmap_pars_fragment:pm,envmap_pars_vertex:mm,envmap_physical_pars_fragment:Tm,envmap_vertex:gm,fog_vertex:_m,fog_pars_vertex:vm,fog_fragment:xm,fog_pars_fragment:Sm,gradientmap_pars_fragment:Mm,lightmap_pars_fragment:wm,lights_lambert_fragment:ym,lights_lambert_pars_fragment:Em,lights_pars_begin:bm,lights_toon_fragment:Am,lights_toon_pars_fragment:Rm,lights_phong_fragment:Cm,lights_phong_pars_fragment:Pm,lights_physical_fragment:Lm,lights_physical_pars_fragment:Im,lights_fragment_begin:Dm,lights_fragment_maps:Nm,lights_fragment_end:Um,lightprobes_pars_fragment:Fm,logdepthbuf_fragment:Om,logdepthbuf_pars_fragment:km,logdepthbuf_pars_vertex:Bm,logdepthbuf_vertex:zm,map_fragment:Hm,map_pars_fragment:Gm,map_particle_fragment:Vm,map_particle_pars_fragment:Wm,metalnessmap_fragment:Xm,metalnessmap_pars_fragment:qm,morphinstance_vertex:$m,morphcolor_vertex:Ym,morphnormal_vertex:Km,morphtarget_pars_vertex:Zm,morphtarget_vertex:Jm,normal_fragment_begin:Qm,normal_fragment_maps:jm,normal_pars_fragment:tg,normal_pars_vertex:eg,normal_vertex:ng,normalmap_pars_fragment:ig,clearcoat_normal_fragment_begin:sg,clearcoat_normal_fragment_maps:rg,clearcoat_pars_fragment:og,iridescence_pars_fragment:ag,opaque_fragment:lg,packing:cg,premultiplied_alpha_fragment:hg,project_vertex:ug,dithering_fragment:dg,dithering_pars_fragment:fg,roughnessmap_fragment:pg,roughnessmap_pars_fragment:mg,shadowmap_pars_fragment:gg,shadowmap_pars_vertex:_g,shadowmap_vertex:vg,shadowmask_pars_fragment:xg,skinbase_vertex:Sg,skinning_pars_vertex:Mg,skinning_vertex:wg,skinnormal_vertex:yg,specularmap_fragment:Eg,specularmap_pars_fragment:bg,tonemapping_fragment:Tg,tonemapping_pars_fragment:Ag,transmission_fragment:Rg,transmission_pars_fragment:Cg,uv_pars_fragment:Pg,uv_pars_vertex:Lg,uv_vertex:Ig,worldpos_vertex:Dg,background_vert:Ng,background_frag:Ug,backgroundCube_vert:Fg,backgroundCube_frag:Og,cube_vert:kg,cube_frag:Bg,depth_vert:zg,depth_frag:Hg,distance_vert:Gg,distance_frag:Vg,equirect_vert:Wg,equirect_frag:Xg,linedashed_vert:qg,linedashed_frag:$g,meshbasic_vert:Yg,meshbasic_frag:Kg,meshlambert_vert:Zg,meshlambert_frag:Jg,meshmatcap_vert:Qg,meshmatcap_frag:jg,meshnormal_vert:t0,meshnormal_frag:e0,meshphong_vert:n0,meshphong_frag:i0,meshphysical_vert:s0,meshphysical_frag:r0,meshtoon_vert:o0,meshtoon_frag:a0,points_vert:l0,points_frag:c0,shadow_vert:h0,shadow_frag:u0,sprite_vert:d0,sprite_frag:f0},pt={common:{diffuse:{value:new zt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Lt},alphaMap:{value:null},alphaMapTransform:{value:new Lt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Lt}},envmap:{envMap:{value:null},envMapRotation:{value:new Lt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Lt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Lt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Lt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Lt},normalScale:{value:new $t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Lt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Lt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Lt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Lt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new zt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new zt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Lt},alphaTest:{value:0},uvTransform:{value:new Lt}},sprite:{diffuse:{value:new zt(16777215)},opacity:{value:1},center:{value:new $t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Lt},alphaMap:{value:null},alphaMapTransform:{value:new Lt},alphaTest:{value:0}}},_n={basic:{uniforms:Ne([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.fog]),vertexShader:kt.meshbasic_vert,fragmentShader:kt.meshbasic_frag},lambert:{uniforms:Ne([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,pt.lights,{emissive:{value:new zt(0)},envMapIntensity:{value:1}}]),vertexShader:kt.meshlambert_vert,fragmentShader:kt.meshlambert_frag},phong:{uniforms:Ne([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,pt.lights,{emissive:{value:new zt(0)},specular:{value:new zt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:kt.meshphong_vert,fragmentShader:kt.meshphong_frag},standard:{uniforms:Ne([pt.common,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.roughnessmap,pt.metalnessmap,pt.fog,pt.lights,{emissive:{value:new zt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:kt.meshphysical_vert,fragmentShader:kt.meshphysical_frag},toon:{uniforms:Ne([pt.common,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.gradientmap,pt.fog,pt.lights,{emissive:{value:new zt(0)}}]),vertexShader:kt.meshtoon_vert,fragmentShader:kt.meshtoon_frag},matcap:{uniforms:Ne([pt.common,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,{matcap:{value:null}}]),vertexShader:kt.meshmatcap_vert,fragmentShader:kt.meshmatcap_frag},points:{uniforms:Ne([pt.points,pt.fog]),vertexShader:kt.points_vert,fragmentShader:kt.points_frag},dashed:{uniforms:Ne([pt.common,pt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:kt.linedashed_vert,fragmentShader:kt.linedashed_frag},depth:{uniforms:Ne([pt.common,pt.displacementmap]),vertexShader:kt.depth_vert,fragmentShader:kt.depth_frag},normal:{uniforms:Ne([pt.common,pt.bumpmap,pt.normalmap,pt.displacementmap,{opacity:{value:1}}]),vertexShader:kt.meshnormal_vert,fragmentShader:kt.meshnormal_frag},sprite:{uniforms:Ne([pt.sprite,pt.fog]),vertexShader:kt.sprite_vert,fragmentShader:kt.sprite_frag},background:{uniforms:{uvTransform:{value:new Lt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:kt.background_vert,fragmentShader:kt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Lt}},vertexShader:kt.backgroundCube_vert,fragmentShader:kt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:kt.cube_vert,fragmentShader:kt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:kt.equirect_vert,fragmentShader:kt.equirect_frag},distance:{uniforms:Ne([pt.common,pt.displacementmap,{referencePosition:{value:new U},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:kt.distance_vert,fragmentShader:kt.distance_frag},shadow:{uniforms:Ne([pt.lights,pt.fog,{color:{value:new zt(0)},opacity:{value:1}}]),vertexShader:kt.shadow_vert,fragmentShader:kt.shadow_frag}};_n.physical={uniforms:Ne([_n.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Lt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Lt},clearcoatNormalScale:{value:new $t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Lt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Lt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Lt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Lt},sheen:{value:0},sheenColor:{value:new zt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Lt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Lt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Lt},transmissionSamplerSize:{value:new $t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Lt},attenuationDistance:{value:0},attenuationColor:{value:new zt(0)},specularColor:{value:new zt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Lt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Lt},anisotropyVector:{value:new $t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Lt}}]),vertexShader:kt.meshphysical_vert,fragmentShader:kt.meshphysical_frag};const nr={r:0,b:0,g:0},p0=new Zt,Xu=new Lt;Xu.set(-1,0,0,0,1,0,0,0,1);function m0(i,t,e,n,s,r){const o=new zt(0);let a=s===!0?0:1,l,c,h=null,d=0,u=null;function f(M){let A=M.isScene===!0?M.background:null;if(A&&A.isTexture){const E=M.backgroundBlurriness>0;A=t.get(A,E)}return A}function v(M){let A=!1;const E=f(M);E===null?m(o,a):E&&E.isColor&&(m(E,1),A=!0);const R=i.xr.getEnvironmentBlendMode();R==="additive"?e.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function S(M,A){const E=f(A);E&&E.isCubeTexture?(c===void 0&&(c=new yn(new Cs(1,1,1),new Mi({name:"BackgroundCubeMaterial",uniforms:Xi(_n.backgroundCube.uniforms),vertexShader:_n.backgroundCube.vertexShader,fragmentShader:_n.backgroundCube.fragmentShader,side:ke,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,b,g){this.matrixWorld.copyPosition(g.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=E,c.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(p0.makeRotationFromEuler(A.backgroundRotation)).transpose(),E.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Xu),c.material.toneMapped=Xt.getTransfer(E.colorSpace)!==te,(h!==E||d!==E.version||u!==i.toneMapping)&&(c.material.needsUpdate=!0,h=E,d=E.version,u=i.toneMapping),c.layers.enableAll(),M.unshift(c,c.geometry,c.material,0,0,null)):E&&E.isTexture&&(l===void 0&&(l=new yn(new Zr(2,2),new Mi({name:"BackgroundMaterial",uniforms:Xi(_n.background.uniforms),vertexShader:_n.background.vertexShader,fragmentShader:_n.background.fragmentShader,side:ei,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=E,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.toneMapped=Xt.getTransfer(E.colorSpace)!==te,E.matrixAutoUpdate===!0&&E.updateMatrix(),l.material.uniforms.uvTransform.value.copy(E.matrix),(h!==E||d!==E.version||u!==i.toneMapping)&&(l.material.needsUpdate=!0,h=E,d=E.version,u=i.toneMapping),l.layers.enableAll(),M.unshift(l,l.geometry,l.material,0,0,null))}function m(M,A){M.getRGB(nr,Gu(i)),e.buffers.color.setClear(nr.r,nr.g,nr.b,A,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(M,A=1){o.set(M),a=A,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(M){a=M,m(o,a)},render:v,addToRenderList:S,dispose:p}}function g0(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=u(null);let r=s,o=!1;function a(D,z,q,P,W){let Z=!1;const H=d(D,P,q,z);r!==H&&(r=H,c(r.object)),Z=f(D,P,q,W),Z&&v(D,P,q,W),W!==null&&t.update(W,i.ELEMENT_ARRAY_BUFFER),(Z||o)&&(o=!1,E(D,z,q,P),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(W).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function h(D){return i.deleteVertexArray(D)}function d(D,z,q,P){const W=P.wireframe===!0;let Z=n[z.id];Z===void 0&&(Z={},n[z.id]=Z);const H=D.isInstancedMesh===!0?D.id:0;let et=Z[H];et===void 0&&(et={},Z[H]=et);let V=et[q.id];V===void 0&&(V={},et[q.id]=V);let Q=V[W];return Q===void 0&&(Q=u(l()),V[W]=Q),Q}function u(D){const z=[],q=[],P=[];for(let W=0;W<e;W++)z[W]=0,q[W]=0,P[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:q,attributeDivisors:P,object:D,attributes:{},index:null}}function f(D,z,q,P){const W=r.attributes,Z=z.attributes;let H=0;const et=q.getAttributes();for(const V in et)if(et[V].location>=0){const j=W[V];let wt=Z[V];if(wt===void 0&&(V==="instanceMatrix"&&D.instanceMatrix&&(wt=D.instanceMatrix),V==="instanceColor"&&D.instanceColor&&(wt=D.instanceColor)),j===void 0||j.attribute!==wt||wt&&j.data!==wt.data)return!0;H++}return r.attributesNum!==H||r.index!==P}function v(D,z,q,P){const W={},Z=z.attributes;let H=0;const et=q.getAttributes();for(const V in et)if(et[V].location>=0){let j=Z[V];j===void 0&&(V==="instanceMatrix"&&D.instanceMatrix&&(j=D.instanceMatrix),V==="instanceColor"&&D.instanceColor&&(j=D.instanceColor));const wt={};wt.attribute=j,j&&j.data&&(wt.data=j.data),W[V]=wt,H++}r.attributes=W,r.attributesNum=H,r.index=P}function S(){const D=r.newAttributes;for(let z=0,q=D.length;z<q;z++)D[z]=0}function m(D){p(D,0)}function p(D,z){const q=r.newAttributes,P=r.enabledAttributes,W=r.attributeDivisors;q[D]=1,P[D]===0&&(i.enableVertexAttribArray(D),P[D]=1),W[D]!==z&&(i.vertexAttribDivisor(D,z),W[D]=z)}function M(){const D=r.newAttributes,z=r.enabledAttributes;for(let q=0,P=z.length;q<P;q++)z[q]!==D[q]&&(i.disableVertexAttribArray(q),z[q]=0)}function A(D,z,q,P,W,Z,H){H===!0?i.vertexAttribIPointer(D,z,q,W,Z):i.vertexAttribPointer(D,z,q,P,W,Z)}function E(D,z,q,P){S();const W=P.attributes,Z=q.getAttributes(),H=z.defaultAttributeValues;for(const et in Z){const V=Z[et];if(V.location>=0){let Q=W[et];if(Q===void 0&&(et==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),et==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){const j=Q.normalized,wt=Q.itemSize,It=t.get(Q);if(It===void 0)continue;const Y=It.buffer,mt=It.type,xt=It.bytesPerElement,Tt=mt===i.INT||mt===i.UNSIGNED_INT||Q.gpuType===ll;if(Q.isInterleavedBufferAttribute){const gt=Q.data,Nt=gt.isInterleavedBuffer===!0?gt.stride:gt.itemSize,ue=Q.offset;if(gt.isInstancedInterleavedBuffer||gt.isInstancedBufferAttribute){for(let Rt=0;Rt<V.locationSize;Rt++)p(V.location+Rt,gt.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=gt.meshPerAttribute*gt.count)}else for(let Rt=0;Rt<V.locationSize;Rt++)m(V.location+Rt);i.bindBuffer(i.ARRAY_BUFFER,Y);for(let Rt=0;Rt<V.locationSize;Rt++)A(V.location+Rt,wt/V.locationSize,mt,j,Nt*xt,(ue+wt/V.locationSize*Rt)*xt,Tt)}else{if(Q.isInstancedBufferAttribute){for(let gt=0;gt<V.locationSize;gt++)p(V.location+gt,Q.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let gt=0;gt<V.locationSize;gt++)m(V.location+gt);i.bindBuffer(i.ARRAY_BUFFER,Y);for(let gt=0;gt<V.locationSize;gt++)A(V.location+gt,wt/V.locationSize,mt,j,wt*xt,wt/V.locationSize*gt*xt,Tt)}}else if(H!==void 0){const j=H[et];if(j!==void 0)switch(j.length){case 2:i.vertexAttrib2fv(V.location,j);break;case 3:i.vertexAttrib3fv(V.location,j);break;case 4:i.vertexAttrib4fv(V.location,j);break;default:i.vertexAttrib1fv(V.location,j)}}}}M()}function R(){k();for(const D in n){const z=n[D];for(const q in z){const P=z[q];for(const W in P){const Z=P[W];for(const H in Z)h(Z[H].object),delete Z[H];delete P[W]}}delete n[D]}}function b(D){if(n[D.id]===void 0)return;const z=n[D.id];for(const q in z){const P=z[q];for(const W in P){const Z=P[W];for(const H in Z)h(Z[H].object),delete Z[H];delete P[W]}}delete n[D.id]}function g(D){for(const z in n){const q=n[z];for(const P in q){const W=q[P];if(W[D.id]===void 0)continue;const Z=W[D.id];for(const H in Z)h(Z[H].object),delete Z[H];delete W[D.id]}}}function y(D){for(const z in n){const q=n[z],P=D.isInstancedMesh===!0?D.id:0,W=q[P];if(W!==void 0){for(const Z in W){const H=W[Z];for(const et in H)h(H[et].object),delete H[et];delete W[Z]}delete q[P],Object.keys(q).length===0&&delete n[z]}}}function k(){L(),o=!0,r!==s&&(r=s,c(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:L,dispose:R,releaseStatesOfGeometry:b,releaseStatesOfObject:y,releaseStatesOfProgram:g,initAttributes:S,enableAttribute:m,disableUnusedAttributes:M}}function _0(i,t,e){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),e.update(c,n,1)}function o(l,c,h){h!==0&&(i.drawArraysInstanced(n,l,c,h),e.update(c,n,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,h);let u=0;for(let f=0;f<h;f++)u+=c[f];e.update(u,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function v0(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const g=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(g.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(g){return!(g!==Qe&&n.convert(g)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(g){const y=g===dn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(g!==Ze&&g!==Je&&!y&&n.convert(g)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(g){if(g==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";g="mediump"}return g==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const h=l(c);h!==c&&(Ct("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);const d=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),u=e.logarithmicDepthBuffer===!0&&d===!1;e.reversedDepthBuffer===!0&&d===!1&&Ct("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&d===!0&&Ct("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");const f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),S=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),M=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),E=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),b=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:u,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:v,maxTextureSize:S,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:M,maxVaryings:A,maxFragmentUniforms:E,maxSamples:R,samples:b}}function x0(i){const t=this;let e=null,n=0,s=!1,r=!1;const o=new Kn,a=new Lt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,u){const f=d.length!==0||u||n!==0||s;return s=u,n=d.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,u){e=h(d,u,0)},this.setState=function(d,u,f){const v=d.clippingPlanes,S=d.clipIntersection,m=d.clipShadows,p=i.get(d);if(!s||v===null||v.length===0||r&&!m)r?h(null):c();else{const M=r?0:n,A=M*4;let E=p.clippingState||null;l.value=E,E=h(v,u,A,f);for(let R=0;R!==A;++R)E[R]=e[R];p.clippingState=E,this.numIntersection=S?this.numPlanes:0,this.numPlanes+=M}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(d,u,f,v){const S=d!==null?d.length:0;let m=null;if(S!==0){if(m=l.value,v!==!0||m===null){const p=f+S*4,M=u.matrixWorldInverse;a.getNormalMatrix(M),(m===null||m.length<p)&&(m=new Float32Array(p));for(let A=0,E=f;A!==S;++A,E+=4)o.copy(d[A]).applyMatrix4(M,a),o.normal.toArray(m,E),m[E+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=S,t.numIntersection=0,m}}class xl extends un{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new Bu(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Cs(5,5,5),r=new Mi({name:"CubemapFromEquirect",uniforms:Xi(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ke,blending:Bi});r.uniforms.tEquirect.value=e;const o=new yn(s,r),a=e.minFilter;return e.minFilter===Qn&&(e.minFilter=Ie),new Ua(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}}const Dc=256,S0=3,M0=20,qu=256,$u=16,w0=3,y0=new U,E0=new zt;class Fr{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ua(1,10,null),this._boxMesh=new yn(new Cs(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){const{size:o=256,position:a=y0}=r,l=this._renderer;this._setSize(o);const c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);const d=l.autoClear,u=l.autoClearColor,f=l.autoClearDepth,v=l.autoClearStencil,S=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,S===null&&(t.background=l.getClearColor(E0));const m=new Ua(n,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=d,l.autoClearColor=u,l.autoClearDepth=f,l.autoClearStencil=v,t.background=S,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Fc(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Uc(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Dc,Zf(t))}_fromTexture(t,e){t.mapping===Vi||t.mapping===bs?this._setSize(t.image.length===0?Dc:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);const n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){const t=this._cubeSize,e=Nc(t,!1,!1),n=Math.log2(t)-S0;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){const e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Nc(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){const s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;const o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Vi||t.mapping===bs?(this._cubemapMaterial===null&&(this._cubemapMaterial=Fc()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Uc()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=b0(),this._integrationMaterial=T0());const e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;const r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/$u);for(let o=0;o<=n;o++){const a=Fr.lodToRoughness(o,n);if(o>n-w0)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{const l=a>0?Math.log2(e)+.5*Math.log2(6/(qu*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=A0());const n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}}function Nc(i,t,e){return new xl(i,{minFilter:Qn,generateMipmaps:t,type:dn,colorSpace:Lr,depthBuffer:e})}function Ps(i,t,e){return new Mi({name:i,uniforms:t,vertexShader:kt.cube_vert,fragmentShader:e,side:ke,blending:Bi,depthTest:!1,depthWrite:!1})}function b0(){return Ps("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${qu}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function T0(){return Ps("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:$u}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function A0(){return Ps("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${M0}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Uc(){return Ps("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Fc(){return Ps("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function R0(i){let t=new WeakMap,e=new WeakMap,n=null;function s(u,f=!1){return u==null?null:f?o(u):r(u)}function r(u){if(u&&u.isTexture){const f=u.mapping;if(f===ro||f===oo)if(t.has(u)){const v=t.get(u).texture;return a(v,u.mapping)}else{const v=u.image;if(v&&v.height>0){const S=new xl(v.height);return S.fromEquirectangularTexture(i,u),t.set(u,S),u.addEventListener("dispose",c),a(S.texture,u.mapping)}else return null}}return u}function o(u){if(u&&u.isTexture&&u.isPMREMTexture!==!0){const f=u.mapping,v=f===ro||f===oo,S=f===Vi||f===bs;if(v||S){let m=e.get(u);const p=m!==void 0?m.texture.pmremVersion:0;if(u.isRenderTargetTexture&&u.pmremVersion!==p)return n===null&&(n=new Fr(i)),m=v?n.fromEquirectangular(u,m):n.fromCubemap(u,m),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),m.texture;if(m!==void 0)return m.texture;{const M=u.image;return v&&M&&M.height>0||S&&M&&l(M)?(n===null&&(n=new Fr(i)),m=v?n.fromEquirectangular(u):n.fromCubemap(u),m.texture.pmremVersion=u.pmremVersion,e.set(u,m),u.addEventListener("dispose",h),m.texture):null}}}return u}function a(u,f){return f===ro?u.mapping=Vi:f===oo&&(u.mapping=bs),u}function l(u){let f=0;const v=6;for(let S=0;S<v;S++)u[S]!==void 0&&f++;return f===v}function c(u){const f=u.target;f.removeEventListener("dispose",c);const v=t.get(f);v!==void 0&&(t.delete(f),v.dispose())}function h(u){const f=u.target;f.removeEventListener("dispose",h);const v=e.get(f);v!==void 0&&(e.delete(f),v.dispose())}function d(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function C0(i){const t={};function e(n){if(t[n]!==void 0)return t[n];const s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&wr("WebGLRenderer: "+n+" extension not supported."),s}}}function P0(i,t,e,n){const s={},r=new WeakMap,o=new FinalizationRegistry(v=>delete s[v]);function a(v){l(v.target)}function l(v){v.index!==null&&t.remove(v.index);for(const m in v.attributes)t.remove(v.attributes[m]);v.removeEventListener("dispose",a),delete s[v.id],o.unregister(v);const S=r.get(v);S&&(t.remove(S),r.delete(v)),n.releaseStatesOfGeometry(v),v.isInstancedBufferGeometry===!0&&delete v._maxInstanceCount,e.memory.geometries--}function c(v,S){return s[S.id]!==void 0||(S.addEventListener("dispose",a),s[S.id]=new WeakRef(S),o.register(S,S.id,S),e.memory.geometries++),S}function h(v){const S=v.attributes;for(const m in S)t.update(S[m],i.ARRAY_BUFFER)}function d(v){const S=v.index,m=v.attributes.position;let p=0;if(m===void 0)return;const M=S!==null?S.array.length:m.array.length/3-1,A=m.count>=65535?ku:Ou,E=new A(Math.ceil(M/3)*6,1),R=E.array;if(S!==null){const g=S.array;p=S.version;for(let y=0,k=0;y<M;y+=3){const L=g[y+0],D=g[y+1],z=g[y+2];R[k++]=L,R[k++]=D,R[k++]=D,R[k++]=z,R[k++]=z,R[k++]=L}}else{p=m.version;for(let g=0,y=0;g<M;g+=3){const k=g+0,L=g+1,D=g+2;R[y++]=k,R[y++]=L,R[y++]=L,R[y++]=D,R[y++]=D,R[y++]=k}}E.version=p;const b=r.get(v);b&&t.remove(b),r.set(v,E)}function u(v){const S=r.get(v);if(S){const m=v.index;m!==null&&S.version<m.version&&d(v)}else d(v);return r.get(v)}function f(){for(const v in s){const S=s[v].deref();S!==void 0&&l(S)}}return{get:c,update:h,getWireframeAttribute:u,dispose:f}}function L0(i,t,e){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,u){i.drawElements(n,u,r,d*o),e.update(u,n,1)}function c(d,u,f){f!==0&&(i.drawElementsInstanced(n,u,r,d*o,f),e.update(u,n,f))}function h(d,u,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,u,0,r,d,0,f);let S=0;for(let m=0;m<f;m++)S+=u[m];e.update(S,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function I0(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:Kt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function D0(i,t,e){const n=new WeakMap,s=new ce;function r(o,a,l){const c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=h!==void 0?h.length:0;let u=n.get(a);if(u===void 0||u.count!==d){let k=function(){g.dispose(),n.delete(a),a.removeEventListener("dispose",k)};u!==void 0&&u.texture.dispose();const f=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,S=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],M=a.morphAttributes.color||[];let A=0;f===!0&&(A=1),v===!0&&(A=2),S===!0&&(A=3);let E=a.attributes.position.count*A,R=1;E>t.maxTextureSize&&(R=Math.ceil(E/t.maxTextureSize),E=t.maxTextureSize);const b=new Float32Array(E*R*4*d),g=new gl(b,E,R,d);g.type=Je,g.needsUpdate=!0;const y=A*4;for(let L=0;L<d;L++){const D=m[L],z=p[L],q=M[L],P=E*R*4*L;for(let W=0;W<D.count;W++){const Z=W*y;f===!0&&(s.fromBufferAttribute(D,W),b[P+Z+0]=s.x,b[P+Z+1]=s.y,b[P+Z+2]=s.z,b[P+Z+3]=0),v===!0&&(s.fromBufferAttribute(z,W),b[P+Z+4]=s.x,b[P+Z+5]=s.y,b[P+Z+6]=s.z,b[P+Z+7]=0),S===!0&&(s.fromBufferAttribute(q,W),b[P+Z+8]=s.x,b[P+Z+9]=s.y,b[P+Z+10]=s.z,b[P+Z+11]=q.itemSize===4?s.w:1)}}u={count:d,texture:g,size:new $t(E,R)},n.set(a,u),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let S=0;S<c.length;S++)f+=c[S];const v=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",v),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",u.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",u.size)}return{update:r}}function N0(i,t,e,n,s){let r=new WeakMap;function o(c){const h=s.render.frame,d=c.geometry,u=t.get(c,d);if(r.get(u)!==h&&(t.update(u),r.set(u,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){const f=c.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return u}function a(){r=new WeakMap}function l(c){const h=c.target;h.removeEventListener("dispose",l),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}const U0={[gu]:"LINEAR_TONE_MAPPING",[_u]:"REINHARD_TONE_MAPPING",[vu]:"CINEON_TONE_MAPPING",[xu]:"ACES_FILMIC_TONE_MAPPING",[Mu]:"AGX_TONE_MAPPING",[wu]:"NEUTRAL_TONE_MAPPING",[Su]:"CUSTOM_TONE_MAPPING"};function F0(i,t,e,n,s,r){const o=new un(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1});let a=null,l=null,c=null;const h=new bn;h.setAttribute("position",new Hn([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Hn([0,2,0,0,2,0],2));const d=new ki({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),u=new yn(h,d),f=new Lp(-1,1,1,-1,0,1);let v=null,S=null,m=!1,p,M=null,A=[],E=!1;this.setSize=function(R,b){o.setSize(R,b),a!==null&&a.setSize(R,b),l!==null&&l.setSize(R,b);for(let g=0;g<A.length;g++){const y=A[g];y.setSize&&y.setSize(R,b)}},this.setEffects=function(R){A=R,E=A.length>0&&A[0].isRenderPass===!0;const b=o.width,g=o.height;A.length>0&&a===null&&(a=new un(b,g,{type:dn,depthBuffer:!1,stencilBuffer:!1}),l=new un(b,g,{type:dn,depthBuffer:!1,stencilBuffer:!1}));const y=s===!0&&A.some(k=>k.needsDepthTexture===!0);y!==(o.depthTexture!==null)&&(y===!0&&c===null&&(c=new Si(b,g),r===!0&&(c.format=jn,c.type=Wi)),o.dispose(),o.depthTexture=y?c:null,o.resolveDepthBuffer=y,o.storeMultisampledDepthBuffer=y);for(let k=0;k<A.length;k++){const L=A[k];L.setSize&&L.setSize(b,g),y&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(R,b){if(m||R.toneMapping===Bn&&A.length===0)return!1;if(M=b,b!==null){const g=b.width,y=b.height;(o.width!==g||o.height!==y)&&this.setSize(g,y)}return E===!1&&R.setRenderTarget(o),p=R.toneMapping,R.toneMapping=Bn,!0},this.hasRenderPass=function(){return E},this.end=function(R,b){R.toneMapping=p,m=!0;let g=o,y=a;for(let k=0;k<A.length;k++){const L=A[k];L.enabled!==!1&&(L.render(R,y,g,b),L.needsSwap!==!1&&(g=y,y=y===a?l:a))}if(v!==R.outputColorSpace||S!==R.toneMapping){v=R.outputColorSpace,S=R.toneMapping,d.defines={},Xt.getTransfer(v)===te&&(d.defines.SRGB_TRANSFER="");const k=U0[S];k&&(d.defines[k]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=g.texture,R.setRenderTarget(M),R.render(u,f),M=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),d.dispose()}}const Yu=new Ue,Ku=new Si(1,1),Zu=new zu(1),Ju=new gl,Qu=new sp,ju=new Bu,Oc=[],kc=[],Bc=new Float32Array(16),zc=new Float32Array(9),Hc=new Float32Array(4);function Zi(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let r=Oc[s];if(r===void 0&&(r=new Float32Array(s),Oc[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function ve(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function xe(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Jr(i,t){let e=kc[t];e===void 0&&(e=new Int32Array(t),kc[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function O0(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function k0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ve(e,t))return;i.uniform2fv(this.addr,t),xe(e,t)}}function B0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(ve(e,t))return;i.uniform3fv(this.addr,t),xe(e,t)}}function z0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ve(e,t))return;i.uniform4fv(this.addr,t),xe(e,t)}}function H0(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(ve(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),xe(e,t)}else{if(ve(e,n))return;Hc.set(n),i.uniformMatrix2fv(this.addr,!1,Hc),xe(e,n)}}function G0(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(ve(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),xe(e,t)}else{if(ve(e,n))return;zc.set(n),i.uniformMatrix3fv(this.addr,!1,zc),xe(e,n)}}function V0(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(ve(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),xe(e,t)}else{if(ve(e,n))return;Bc.set(n),i.uniformMatrix4fv(this.addr,!1,Bc),xe(e,n)}}function W0(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function X0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ve(e,t))return;i.uniform2iv(this.addr,t),xe(e,t)}}function q0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ve(e,t))return;i.uniform3iv(this.addr,t),xe(e,t)}}function $0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ve(e,t))return;i.uniform4iv(this.addr,t),xe(e,t)}}function Y0(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function K0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(ve(e,t))return;i.uniform2uiv(this.addr,t),xe(e,t)}}function Z0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(ve(e,t))return;i.uniform3uiv(this.addr,t),xe(e,t)}}function J0(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(ve(e,t))return;i.uniform4uiv(this.addr,t),xe(e,t)}}function Qr(i){return i.version===0&&(i.compareFunction=Iu,i.needsUpdate=!0),i}function Q0(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Qr(Ku):r=Yu,e.setTexture2D(t||r,s)}function j0(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Qu,s)}function t_(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Qr(Zu):r=ju,e.setTextureCube(t||r,s)}function e_(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Ju,s)}function n_(i){switch(i){case 5126:return O0;case 35664:return k0;case 35665:return B0;case 35666:return z0;case 35674:return H0;case 35675:return G0;case 35676:return V0;case 5124:case 35670:return W0;case 35667:case 35671:return X0;case 35668:case 35672:return q0;case 35669:case 35673:return $0;case 5125:return Y0;case 36294:return K0;case 36295:return Z0;case 36296:return J0;case 35678:case 36198:case 36298:case 36306:case 35682:return Q0;case 35679:case 36299:case 36307:return j0;case 35680:case 36300:case 36308:case 36293:return t_;case 36289:case 36303:case 36311:case 36292:return e_}}function i_(i,t){i.uniform1fv(this.addr,t)}function s_(i,t){const e=Zi(t,this.size,2);i.uniform2fv(this.addr,e)}function r_(i,t){const e=Zi(t,this.size,3);i.uniform3fv(this.addr,e)}function o_(i,t){const e=Zi(t,this.size,4);i.uniform4fv(this.addr,e)}function a_(i,t){const e=Zi(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function l_(i,t){const e=Zi(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function c_(i,t){const e=Zi(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function h_(i,t){i.uniform1iv(this.addr,t)}function u_(i,t){i.uniform2iv(this.addr,t)}function d_(i,t){i.uniform3iv(this.addr,t)}function f_(i,t){i.uniform4iv(this.addr,t)}function p_(i,t){i.uniform1uiv(this.addr,t)}function m_(i,t){i.uniform2uiv(this.addr,t)}function g_(i,t){i.uniform3uiv(this.addr,t)}function __(i,t){i.uniform4uiv(this.addr,t)}function v_(i,t,e){const n=this.cache,s=t.length,r=Jr(e,s);ve(n,r)||(i.uniform1iv(this.addr,r),xe(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Qr(Ku):o=Yu;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function x_(i,t,e){const n=this.cache,s=t.length,r=Jr(e,s);ve(n,r)||(i.uniform1iv(this.addr,r),xe(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Qu,r[o])}function S_(i,t,e){const n=this.cache,s=t.length,r=Jr(e,s);ve(n,r)||(i.uniform1iv(this.addr,r),xe(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Qr(Zu):o=ju;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function M_(i,t,e){const n=this.cache,s=t.length,r=Jr(e,s);ve(n,r)||(i.uniform1iv(this.addr,r),xe(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Ju,r[o])}function w_(i){switch(i){case 5126:return i_;case 35664:return s_;case 35665:return r_;case 35666:return o_;case 35674:return a_;case 35675:return l_;case 35676:return c_;case 5124:case 35670:return h_;case 35667:case 35671:return u_;case 35668:case 35672:return d_;case 35669:case 35673:return f_;case 5125:return p_;case 36294:return m_;case 36295:return g_;case 36296:return __;case 35678:case 36198:case 36298:case 36306:case 35682:return v_;case 35679:case 36299:case 36307:return x_;case 35680:case 36300:case 36308:case 36293:return S_;case 36289:case 36303:case 36311:case 36292:return M_}}class y_{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=n_(e.type)}}class E_{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=w_(e.type)}}class b_{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],n)}}}const Io=/(\w+)(\])?(\[|\.)?/g;function Gc(i,t){i.seq.push(t),i.map[t.id]=t}function T_(i,t,e){const n=i.name,s=n.length;for(Io.lastIndex=0;;){const r=Io.exec(n),o=Io.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Gc(e,c===void 0?new y_(a,i,t):new E_(a,i,t));break}else{let d=e.map[a];d===void 0&&(d=new b_(a),Gc(e,d)),e=d}}}class yr{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){const a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);T_(a,l,this)}const s=[],r=[];for(const o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){const r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&n.push(o)}return n}}function Vc(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const A_=37297;let R_=0;function C_(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}const Wc=new Lt;function P_(i){Xt._getMatrix(Wc,Xt.workingColorSpace,i);const t=`mat3( ${Wc.elements.map(e=>e.toFixed(4))} )`;switch(Xt.getTransfer(i)){case Ir:return[t,"LinearTransferOETF"];case te:return[t,"sRGBTransferOETF"];default:return Ct("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Xc(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";const o=/ERROR: 0:(\d+)/.exec(r);if(o){const a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+C_(i.getShaderSource(t),a)}else return r}function L_(i,t){const e=P_(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}const I_={[gu]:"Linear",[_u]:"Reinhard",[vu]:"Cineon",[xu]:"ACESFilmic",[Mu]:"AgX",[wu]:"Neutral",[Su]:"Custom"};function D_(i,t){const e=I_[t];return e===void 0?(Ct("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const ir=new U;function N_(){Xt.getLuminanceCoefficients(ir);const i=ir.x.toFixed(4),t=ir.y.toFixed(4),e=ir.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function U_(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(_s).join(`
`)}function F_(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function O_(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(t,s),o=r.name;let a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function _s(i){return i!==""}function qc(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function $c(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const k_=/^[ \t]*#include +<([\w\d./]+)>/gm;function Fa(i){return i.replace(k_,B_)}function B_(i,t){const e=kt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Fa(e)}const z_=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Yc(i){return i.replace(z_,H_)}function H_(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Kc(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}const G_={[_r]:"SHADOWMAP_TYPE_PCF",[gs]:"SHADOWMAP_TYPE_VSM"};function V_(i){return G_[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}const W_={[bs]:"ENVMAP_MODE_REFRACTION"};function X_(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":W_[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}const q_={[mu]:"ENVMAP_BLENDING_MULTIPLY",[Df]:"ENVMAP_BLENDING_MIX",[Nf]:"ENVMAP_BLENDING_ADD"};function $_(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":q_[i.combine]||"ENVMAP_BLENDING_NONE"}function Y_(i,t,e,n){const s=i.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=V_(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=X_(e),d=$_(e),u=U_(e),f=F_(r),v=s.createProgram();let S,m,p=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(S=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(_s).join(`
`),S.length>0&&(S+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(_s).join(`
`),m.length>0&&(m+=`
`)):(S=[Kc(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(_s).join(`
`),m=[Kc(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+d:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Bn?"#define TONE_MAPPING":"",e.toneMapping!==Bn?kt.tonemapping_pars_fragment:"",e.toneMapping!==Bn?D_("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",kt.colorspace_pars_fragment,L_("linearToOutputTexel",e.outputColorSpace),N_(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(_s).join(`
`)),o=Fa(o),o=qc(o,e),o=$c(o,e),a=Fa(a),a=qc(a,e),a=$c(a,e),o=Yc(o),a=Yc(a),e.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,S=[u,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+S,m=["#define varying in",e.glslVersion===fi?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===fi?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);const M=p+S+o,A=p+m+a,E=Vc(s,s.VERTEX_SHADER,M),R=Vc(s,s.FRAGMENT_SHADER,A);s.attachShader(v,E),s.attachShader(v,R),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function b(L){if(i.debug.checkShaderErrors){const D=s.getProgramInfoLog(v)||"",z=s.getShaderInfoLog(E)||"",q=s.getShaderInfoLog(R)||"",P=D.trim(),W=z.trim(),Z=q.trim();let H=!0,et=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,E,R);else{const V=Xc(s,E,"vertex"),Q=Xc(s,R,"fragment");Kt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+P+`
`+V+`
`+Q)}else P!==""?Ct("WebGLProgram: Program Info Log:",P):(W===""||Z==="")&&(et=!1);et&&(L.diagnostics={runnable:H,programLog:P,vertexShader:{log:W,prefix:S},fragmentShader:{log:Z,prefix:m}})}s.deleteShader(E),s.deleteShader(R),g=new yr(s,v),y=O_(s,v)}let g;this.getUniforms=function(){return g===void 0&&b(this),g};let y;this.getAttributes=function(){return y===void 0&&b(this),y};let k=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(v,A_)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=R_++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=E,this.fragmentShader=R,this}let K_=0;class Z_{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){const s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new J_(t),e.set(t,n)),n}}class J_{constructor(t){this.id=K_++,this.code=t,this.usedTimes=0}}function Q_(i){return i===ii||i===Cr||i===Pr}function j_(i,t,e,n,s,r){const o=new Nu,a=new Z_,l=new Set,c=[],h=new Map,d=n.logarithmicDepthBuffer,u={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(g){return l.add(g),g===0?"uv":`uv${g}`}function v(g,y,k,L,D,z){const q=L.fog,P=D.geometry,W=g.isMeshStandardMaterial||g.isMeshLambertMaterial||g.isMeshPhongMaterial?L.environment:null,Z=g.isMeshStandardMaterial||g.isMeshLambertMaterial&&!g.envMap||g.isMeshPhongMaterial&&!g.envMap,H=t.get(g.envMap||W,Z),et=u[g.type];let V=n.precision;g.precision!==null&&(V=n.getMaxPrecision(g.precision),V!==g.precision&&Ct("WebGLProgram.getParameters:",g.precision,"not supported, using",V,"instead."));const Q=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,j=Q!==void 0?Q.length:0;let wt=0;P.morphAttributes.position!==void 0&&(wt=1),P.morphAttributes.normal!==void 0&&(wt=2),P.morphAttributes.color!==void 0&&(wt=3);let It,Y,mt,xt;if(et){const ft=_n[et];It=ft.vertexShader,Y=ft.fragmentShader}else{It=g.vertexShader,Y=g.fragmentShader;const ft=a.getVertexShaderStage(g),jt=a.getFragmentShaderStage(g);a.update(g,ft,jt),mt=ft.id,xt=jt.id}const Tt=i.getRenderTarget(),gt=i.state.buffers.depth.getReversed(),Nt=D.isInstancedMesh===!0,ue=D.isBatchedMesh===!0,Rt=!!g.map,Qt=!!g.matcap,ne=!!H,Ht=ne&&H.isPMREMTexture===!0,be=!!g.aoMap,ge=!!g.lightMap,Oe=!!g.bumpMap&&g.wireframe===!1,ae=!!g.normalMap,fn=!!g.displacementMap,Se=!!g.emissiveMap,Ve=!!g.metalnessMap,We=!!g.roughnessMap,Xe=g.anisotropy>0,I=g.clearcoat>0,qe=g.diffuseRoughness>0,re=g.dispersion>0,oe=g.retroreflectivity>0,ut=g.iridescence>0,_e=g.sheen>0,At=g.transmission>0,Pt=Xe&&!!g.anisotropyMap,w=I&&!!g.clearcoatMap,_=I&&!!g.clearcoatNormalMap,F=I&&!!g.clearcoatRoughnessMap,tt=qe&&!!g.diffuseRoughnessMap,J=ut&&!!g.iridescenceMap,st=ut&&!!g.iridescenceThicknessMap,ct=_e&&!!g.sheenColorMap,X=_e&&!!g.sheenRoughnessMap,$=!!g.specularMap,ot=!!g.specularColorMap,T=!!g.specularIntensityMap,K=At&&!!g.transmissionMap,G=At&&!!g.thicknessMap,at=!!g.gradientMap,it=!!g.alphaMap,rt=g.alphaTest>0,Et=!!g.alphaHash,Ot=!!g.extensions;let nt=Bn;g.toneMapped&&(Tt===null||Tt.isXRRenderTarget===!0)&&(nt=i.toneMapping);const bt=Ht?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Ft={shaderID:et,shaderType:g.type,shaderName:g.name,vertexShader:It,fragmentShader:Y,defines:g.defines,customVertexShaderID:mt,customFragmentShaderID:xt,isRawShaderMaterial:g.isRawShaderMaterial===!0,glslVersion:g.glslVersion,precision:V,batching:ue,batchingColor:ue&&D._colorsTexture!==null,instancing:Nt,instancingColor:Nt&&D.instanceColor!==null,instancingMorph:Nt&&D.morphTexture!==null,outputColorSpace:Tt===null?i.outputColorSpace:Tt.isXRRenderTarget===!0?Tt.texture.colorSpace:Xt.workingColorSpace,alphaToCoverage:!!g.alphaToCoverage,map:Rt,matcap:Qt,envMap:ne,envMapMode:ne&&H.mapping,envMapPMREM:Ht,envMapMaxLod:Ht?bt.length-1:null,envMapSize:Ht?bt[0].width:null,aoMap:be,lightMap:ge,bumpMap:Oe,normalMap:ae,displacementMap:fn,emissiveMap:Se,normalMapObjectSpace:ae&&g.normalMapType===Of,normalMapTangentSpace:ae&&g.normalMapType===uc,packedNormalMap:ae&&g.normalMapType===uc&&Q_(g.normalMap.format),metalnessMap:Ve,roughnessMap:We,anisotropy:Xe,anisotropyMap:Pt,clearcoat:I,clearcoatMap:w,clearcoatNormalMap:_,clearcoatRoughnessMap:F,diffuseRoughness:qe,diffuseRoughnessMap:tt,dispersion:re,retroreflection:oe,iridescence:ut,iridescenceMap:J,iridescenceThicknessMap:st,sheen:_e,sheenColorMap:ct,sheenRoughnessMap:X,specularMap:$,specularColorMap:ot,specularIntensityMap:T,transmission:At,transmissionMap:K,thicknessMap:G,gradientMap:at,opaque:g.transparent===!1&&g.blending===Ss&&g.alphaToCoverage===!1,alphaMap:it,alphaTest:rt,alphaHash:Et,combine:g.combine,mapUv:Rt&&f(g.map.channel),aoMapUv:be&&f(g.aoMap.channel),lightMapUv:ge&&f(g.lightMap.channel),bumpMapUv:Oe&&f(g.bumpMap.channel),normalMapUv:ae&&f(g.normalMap.channel),displacementMapUv:fn&&f(g.displacementMap.channel),emissiveMapUv:Se&&f(g.emissiveMap.channel),metalnessMapUv:Ve&&f(g.metalnessMap.channel),roughnessMapUv:We&&f(g.roughnessMap.channel),anisotropyMapUv:Pt&&f(g.anisotropyMap.channel),clearcoatMapUv:w&&f(g.clearcoatMap.channel),clearcoatNormalMapUv:_&&f(g.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:F&&f(g.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:tt&&f(g.diffuseRoughnessMap.channel),iridescenceMapUv:J&&f(g.iridescenceMap.channel),iridescenceThicknessMapUv:st&&f(g.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&f(g.sheenColorMap.channel),sheenRoughnessMapUv:X&&f(g.sheenRoughnessMap.channel),specularMapUv:$&&f(g.specularMap.channel),specularColorMapUv:ot&&f(g.specularColorMap.channel),specularIntensityMapUv:T&&f(g.specularIntensityMap.channel),transmissionMapUv:K&&f(g.transmissionMap.channel),thicknessMapUv:G&&f(g.thicknessMap.channel),alphaMapUv:it&&f(g.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(ae||Xe),vertexNormals:!!P.attributes.normal,vertexColors:g.vertexColors,vertexAlphas:g.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!P.attributes.uv&&(Rt||it),fog:!!q,useFog:g.fog===!0,fogExp2:!!q&&q.isFogExp2,flatShading:g.wireframe===!1&&(g.flatShading===!0||P.attributes.normal===void 0&&ae===!1&&(g.isMeshLambertMaterial||g.isMeshPhongMaterial||g.isMeshStandardMaterial||g.isMeshPhysicalMaterial)),sizeAttenuation:g.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:gt,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:j,morphTextureStride:wt,numSunLights:y.sun.length,numDirLights:y.directional.length,numPointLights:y.point.length,numSpotLights:y.spot.length,numSpotLightMaps:y.spotLightMap.length,numRectAreaLights:y.rectArea.length,numHemiLights:y.hemi.length,numSunLightShadows:y.sunShadowMap.length,numDirLightShadows:y.directionalShadowMap.length,numPointLightShadows:y.pointShadowMap.length,numSpotLightShadows:y.spotShadowMap.length,numSpotLightShadowsWithMaps:y.numSpotLightShadowsWithMaps,numLightProbes:y.numLightProbes,numLightProbeGrids:z.filter(ft=>ft.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:g.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Rt&&g.map.isVideoTexture===!0&&Xt.getTransfer(g.map.colorSpace)===te,decodeVideoTextureEmissive:Se&&g.emissiveMap.isVideoTexture===!0&&Xt.getTransfer(g.emissiveMap.colorSpace)===te,premultipliedAlpha:g.premultipliedAlpha,doubleSided:g.side===xn,flipSided:g.side===ke,useDepthPacking:g.depthPacking>=0,depthPacking:g.depthPacking||0,index0AttributeName:g.index0AttributeName,extensionClipCullDistance:Ot&&g.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ot&&g.extensions.multiDraw===!0||ue)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:g.customProgramCacheKey()};return Ft.vertexUv1s=l.has(1),Ft.vertexUv2s=l.has(2),Ft.vertexUv3s=l.has(3),l.clear(),Ft}function S(g){const y=[];if(g.shaderID?y.push(g.shaderID):(y.push(g.customVertexShaderID),y.push(g.customFragmentShaderID)),g.defines!==void 0)for(const k in g.defines)y.push(k),y.push(g.defines[k]);return g.isRawShaderMaterial===!1&&(m(y,g),p(y,g),y.push(i.outputColorSpace)),y.push(g.customProgramCacheKey),y.join()}function m(g,y){g.push(y.precision),g.push(y.outputColorSpace),g.push(y.envMapMode),g.push(y.envMapPMREM),g.push(y.envMapMaxLod),g.push(y.envMapSize),g.push(y.mapUv),g.push(y.alphaMapUv),g.push(y.lightMapUv),g.push(y.aoMapUv),g.push(y.bumpMapUv),g.push(y.normalMapUv),g.push(y.displacementMapUv),g.push(y.emissiveMapUv),g.push(y.metalnessMapUv),g.push(y.roughnessMapUv),g.push(y.anisotropyMapUv),g.push(y.clearcoatMapUv),g.push(y.clearcoatNormalMapUv),g.push(y.clearcoatRoughnessMapUv),g.push(y.diffuseRoughnessMapUv),g.push(y.iridescenceMapUv),g.push(y.iridescenceThicknessMapUv),g.push(y.sheenColorMapUv),g.push(y.sheenRoughnessMapUv),g.push(y.specularMapUv),g.push(y.specularColorMapUv),g.push(y.specularIntensityMapUv),g.push(y.transmissionMapUv),g.push(y.thicknessMapUv),g.push(y.combine),g.push(y.fogExp2),g.push(y.sizeAttenuation),g.push(y.morphTargetsCount),g.push(y.numSunLights),g.push(y.numDirLights),g.push(y.numPointLights),g.push(y.numSpotLights),g.push(y.numSpotLightMaps),g.push(y.numHemiLights),g.push(y.numRectAreaLights),g.push(y.numSunLightShadows),g.push(y.numDirLightShadows),g.push(y.numPointLightShadows),g.push(y.numSpotLightShadows),g.push(y.numSpotLightShadowsWithMaps),g.push(y.numLightProbes),g.push(y.numLightProbeGrids),g.push(y.shadowMapType),g.push(y.toneMapping),g.push(y.numClippingPlanes),g.push(y.numClipIntersection),g.push(y.depthPacking)}function p(g,y){o.disableAll(),y.instancing&&o.enable(0),y.instancingColor&&o.enable(1),y.instancingMorph&&o.enable(2),y.matcap&&o.enable(3),y.envMap&&o.enable(4),y.normalMapObjectSpace&&o.enable(5),y.normalMapTangentSpace&&o.enable(6),y.clearcoat&&o.enable(7),y.iridescence&&o.enable(8),y.alphaTest&&o.enable(9),y.vertexColors&&o.enable(10),y.vertexAlphas&&o.enable(11),y.vertexUv1s&&o.enable(12),y.vertexUv2s&&o.enable(13),y.vertexUv3s&&o.enable(14),y.vertexTangents&&o.enable(15),y.anisotropy&&o.enable(16),y.alphaHash&&o.enable(17),y.batching&&o.enable(18),y.dispersion&&o.enable(19),y.retroreflection&&o.enable(24),y.diffuseRoughness&&o.enable(25),y.batchingColor&&o.enable(20),y.gradientMap&&o.enable(21),y.packedNormalMap&&o.enable(22),y.vertexNormals&&o.enable(23),g.push(o.mask),o.disableAll(),y.fog&&o.enable(0),y.useFog&&o.enable(1),y.flatShading&&o.enable(2),y.logarithmicDepthBuffer&&o.enable(3),y.reversedDepthBuffer&&o.enable(4),y.skinning&&o.enable(5),y.morphTargets&&o.enable(6),y.morphNormals&&o.enable(7),y.morphColors&&o.enable(8),y.premultipliedAlpha&&o.enable(9),y.shadowMapEnabled&&o.enable(10),y.doubleSided&&o.enable(11),y.flipSided&&o.enable(12),y.useDepthPacking&&o.enable(13),y.dithering&&o.enable(14),y.transmission&&o.enable(15),y.sheen&&o.enable(16),y.opaque&&o.enable(17),y.pointsUvs&&o.enable(18),y.decodeVideoTexture&&o.enable(19),y.decodeVideoTextureEmissive&&o.enable(20),y.alphaToCoverage&&o.enable(21),y.numLightProbeGrids>0&&o.enable(22),y.hasPositionAttribute&&o.enable(23),g.push(o.mask)}function M(g){const y=u[g.type];let k;if(y){const L=_n[y];k=Tp.clone(L.uniforms)}else k=g.uniforms;return k}function A(g,y){let k=h.get(y);return k!==void 0?++k.usedTimes:(k=new Y_(i,y,g,s),c.push(k),h.set(y,k)),k}function E(g){if(--g.usedTimes===0){const y=c.indexOf(g);c[y]=c[c.length-1],c.pop(),h.delete(g.cacheKey),g.destroy()}}function R(g){a.remove(g)}function b(){a.dispose()}return{getParameters:v,getProgramCacheKey:S,getUniforms:M,acquireProgram:A,releaseProgram:E,releaseShaderCache:R,programs:c,dispose:b}}function tv(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function ev(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function Zc(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Jc(){const i=[];let t=0;const e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(u){let f=0;return u.isInstancedMesh&&(f+=2),u.isSkinnedMesh&&(f+=1),f}function a(u,f,v,S,m,p){let M=i[t];return M===void 0?(M={id:u.id,object:u,geometry:f,material:v,materialVariant:o(u),groupOrder:S,renderOrder:u.renderOrder,z:m,group:p},i[t]=M):(M.id=u.id,M.object=u,M.geometry=f,M.material=v,M.materialVariant=o(u),M.groupOrder=S,M.renderOrder=u.renderOrder,M.z=m,M.group=p),t++,M}function l(u,f,v,S,m,p,M){M.reversedDepth===!0&&(m=-m);const A=a(u,f,v,S,m,p);v.transmission>0?n.push(A):v.transparent===!0?s.push(A):e.push(A)}function c(u,f,v,S,m,p){const M=a(u,f,v,S,m,p);v.transmission>0?n.unshift(M):v.transparent===!0?s.unshift(M):e.unshift(M)}function h(u,f){e.length>1&&e.sort(u||ev),n.length>1&&n.sort(f||Zc),s.length>1&&s.sort(f||Zc)}function d(){for(let u=t,f=i.length;u<f;u++){const v=i[u];if(v.id===null)break;v.id=null,v.object=null,v.geometry=null,v.material=null,v.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:d,sort:h}}function nv(){let i=new WeakMap;function t(n,s){const r=i.get(n);let o;return r===void 0?(o=new Jc,i.set(n,[o])):s>=r.length?(o=new Jc,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function iv(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new U,color:new zt};break;case"SpotLight":e={position:new U,direction:new U,color:new zt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new U,color:new zt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new U,skyColor:new zt,groundColor:new zt};break;case"RectAreaLight":e={color:new zt,position:new U,halfWidth:new U,halfHeight:new U};break}return i[t.id]=e,e}}}function sv(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $t};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $t};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new $t,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let rv=0;function ov(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function av(i){const t=new iv,e=sv(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new U);const s=new U,r=new Zt,o=new Zt;function a(c){let h=0,d=0,u=0;for(let z=0;z<9;z++)n.probe[z].set(0,0,0);let f=0,v=0,S=0,m=0,p=0,M=0,A=0,E=0,R=0,b=0,g=0,y=0,k=0,L=0;c.sort(ov);for(let z=0,q=c.length;z<q;z++){const P=c[z],W=P.color,Z=P.intensity,H=P.distance;let et=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===ii?et=P.shadow.map.texture:et=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=W.r*Z,d+=W.g*Z,u+=W.b*Z;else if(P.isLightProbe){for(let V=0;V<9;V++)n.probe[V].addScaledVector(P.sh.coefficients[V],Z);L++}else if(P.isSunLight){const V=t.get(P);if(V.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){const Q=P.shadow,j=e.get(P);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[v]=j,n.sunShadowMap[v]=et;const wt=Q.getViewportCount();for(let It=0;It<wt;It++)n.sunShadowMatrix[S+It]=Q.getMatrix(It),n.sunShadowCascade[S+It]=Q._cascadeData[It];S+=wt,v++}n.sun[f]=V,f++}else if(P.isDirectionalLight){const V=t.get(P);if(V.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){const Q=P.shadow,j=e.get(P);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,n.directionalShadow[m]=j,n.directionalShadowMap[m]=et,n.directionalShadowMatrix[m]=P.shadow.matrix,R++}n.directional[m]=V,m++}else if(P.isSpotLight){const V=t.get(P);V.position.setFromMatrixPosition(P.matrixWorld),V.color.copy(W).multiplyScalar(Z),V.distance=H,V.coneCos=Math.cos(P.angle),V.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),V.decay=P.decay,n.spot[M]=V;const Q=P.shadow;if(P.map&&(n.spotLightMap[y]=P.map,y++,Q.updateMatrices(P),P.castShadow&&k++),n.spotLightMatrix[M]=Q.matrix,P.castShadow){const j=e.get(P);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,n.spotShadow[M]=j,n.spotShadowMap[M]=et,g++}M++}else if(P.isRectAreaLight){const V=t.get(P);V.color.copy(W).multiplyScalar(Z),V.halfWidth.set(P.width*.5,0,0),V.halfHeight.set(0,P.height*.5,0),n.rectArea[A]=V,A++}else if(P.isPointLight){const V=t.get(P);if(V.color.copy(P.color).multiplyScalar(P.intensity),V.distance=P.distance,V.decay=P.decay,P.castShadow){const Q=P.shadow,j=e.get(P);j.shadowIntensity=Q.intensity,j.shadowBias=Q.bias,j.shadowNormalBias=Q.normalBias,j.shadowRadius=Q.radius,j.shadowMapSize=Q.mapSize,j.shadowCameraNear=Q.camera.near,j.shadowCameraFar=Q.camera.far,n.pointShadow[p]=j,n.pointShadowMap[p]=et,n.pointShadowMatrix[p]=P.shadow.matrix,b++}n.point[p]=V,p++}else if(P.isHemisphereLight){const V=t.get(P);V.skyColor.copy(P.color).multiplyScalar(Z),V.groundColor.copy(P.groundColor).multiplyScalar(Z),n.hemi[E]=V,E++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=pt.LTC_FLOAT_1,n.rectAreaLTC2=pt.LTC_FLOAT_2):(n.rectAreaLTC1=pt.LTC_HALF_1,n.rectAreaLTC2=pt.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=d,n.ambient[2]=u;const D=n.hash;(D.sunLength!==f||D.directionalLength!==m||D.pointLength!==p||D.spotLength!==M||D.rectAreaLength!==A||D.hemiLength!==E||D.numSunShadows!==v||D.numDirectionalShadows!==R||D.numPointShadows!==b||D.numSpotShadows!==g||D.numSpotMaps!==y||D.numLightProbes!==L)&&(n.sun.length=f,n.directional.length=m,n.spot.length=M,n.rectArea.length=A,n.point.length=p,n.hemi.length=E,n.sunShadow.length=v,n.sunShadowMap.length=v,n.sunShadowMatrix.length=S,n.sunShadowCascade.length=S,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=b,n.pointShadowMap.length=b,n.pointShadowMatrix.length=b,n.spotShadow.length=g,n.spotShadowMap.length=g,n.spotLightMatrix.length=g+y-k,n.spotLightMap.length=y,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=L,D.sunLength=f,D.directionalLength=m,D.pointLength=p,D.spotLength=M,D.rectAreaLength=A,D.hemiLength=E,D.numSunShadows=v,D.numDirectionalShadows=R,D.numPointShadows=b,D.numSpotShadows=g,D.numSpotMaps=y,D.numLightProbes=L,n.version=rv++)}function l(c,h){let d=0,u=0,f=0,v=0,S=0,m=0;const p=h.matrixWorldInverse;for(let M=0,A=c.length;M<A;M++){const E=c[M];if(E.isSunLight){const R=n.sun[d];R.direction.setFromMatrixPosition(E.matrixWorld),R.direction.transformDirection(p),d++}else if(E.isDirectionalLight){const R=n.directional[u];R.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),u++}else if(E.isSpotLight){const R=n.spot[v];R.position.setFromMatrixPosition(E.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(E.matrixWorld),s.setFromMatrixPosition(E.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),v++}else if(E.isRectAreaLight){const R=n.rectArea[S];R.position.setFromMatrixPosition(E.matrixWorld),R.position.applyMatrix4(p),o.identity(),r.copy(E.matrixWorld),r.premultiply(p),o.extractRotation(r),R.halfWidth.set(E.width*.5,0,0),R.halfHeight.set(0,E.height*.5,0),R.halfWidth.applyMatrix4(o),R.halfHeight.applyMatrix4(o),S++}else if(E.isPointLight){const R=n.point[f];R.position.setFromMatrixPosition(E.matrixWorld),R.position.applyMatrix4(p),f++}else if(E.isHemisphereLight){const R=n.hemi[m];R.direction.setFromMatrixPosition(E.matrixWorld),R.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:n}}function Qc(i){const t=new av(i),e=[],n=[],s=[];function r(d){h.camera=d,e.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):e.push(d)}function a(d){n.push(d)}function l(){t.setup(e),s.sort((d,u)=>d.priority-u.priority||d.id-u.id)}function c(d){t.setupView(e,d)}const h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function lv(i){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new Qc(i),t.set(s,[a])):r>=o.length?(a=new Qc(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}const cv=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,hv=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,uv=[new U(1,0,0),new U(-1,0,0),new U(0,1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1)],dv=[new U(0,-1,0),new U(0,-1,0),new U(0,0,1),new U(0,0,-1),new U(0,-1,0),new U(0,-1,0)],jc=new Zt,ss=new U,Do=new U;function fv(i,t,e){let n=new Ur;const s=new $t,r=new $t,o=new ce,a=new Cp,l=new Pp,c={},h=e.maxTextureSize,d={[ei]:ke,[ke]:ei,[xn]:xn},u=new Mi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new $t},radius:{value:4}},vertexShader:cv,fragmentShader:hv}),f=u.clone();f.defines.HORIZONTAL_PASS=1;const v=new bn;v.setAttribute("position",new je(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const S=new yn(v,u),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=_r;let p=this.type;this.render=function(b,g,y){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||b.length===0)return;this.type===pf&&(Ct("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=_r);const k=i.getRenderTarget(),L=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),z=i.state;z.setBlending(Bi),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);const q=p!==this.type;q&&g.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(W=>W.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,W=b.length;P<W;P++){const Z=b[P],H=Z.shadow;if(H===void 0){Ct("WebGLShadowMap:",Z,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);const et=H.getFrameExtents();s.multiply(et),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/et.x),s.x=r.x*et.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/et.y),s.y=r.y*et.y,H.mapSize.y=r.y));const V=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=V,H.map===null||q===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===gs){if(Z.isPointLight){Ct("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new un(s.x,s.y,{format:ii,type:dn,minFilter:Ie,magFilter:Ie,generateMipmaps:!1}),H.map.texture.name=Z.name+".shadowMap",H.map.depthTexture=new Si(s.x,s.y,Je),H.map.depthTexture.name=Z.name+".shadowMapDepth",H.map.depthTexture.format=ni,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=me,H.map.depthTexture.magFilter=me}else Z.isPointLight?(H.map=new xl(s.x),H.map.depthTexture=new zu(s.x,tn)):(H.map=new un(s.x,s.y),H.map.depthTexture=new Si(s.x,s.y,tn)),H.map.depthTexture.name=Z.name+".shadowMap",H.map.depthTexture.format=ni,this.type===_r?(H.map.depthTexture.compareFunction=V?Lu:fl,H.map.depthTexture.minFilter=Ie,H.map.depthTexture.magFilter=Ie):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=me,H.map.depthTexture.magFilter=me);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);const Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();Z.isPointLight!==!0&&H.updateMatrices(Z,y);const j=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:y.layers;for(let wt=0;wt<Q;wt++){const It=H.getCamera(wt);if(Z.isPointLight){const Y=H.camera,mt=H.matrix,xt=Z.distance||Y.far;xt!==Y.far&&(Y.far=xt,Y.updateProjectionMatrix()),ss.setFromMatrixPosition(Z.matrixWorld),Y.position.copy(ss),Do.copy(Y.position),Do.add(uv[wt]),Y.up.copy(dv[wt]),Y.lookAt(Do),Y.updateMatrixWorld(),mt.makeTranslation(-ss.x,-ss.y,-ss.z),jc.multiplyMatrices(Y.projectionMatrix,Y.matrixWorldInverse),H._frustum.setFromProjectionMatrix(jc,Y.coordinateSystem,Y.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,wt),i.clear();else{wt===0&&(i.setRenderTarget(H.map),i.clear());const Y=H.getViewport(wt);o.set(r.x*Y.x,r.y*Y.y,r.x*Y.z,r.y*Y.w),z.viewport(o)}n=H.getFrustum(wt),E(g,y,It,Z,j,this.type)}H.isPointLightShadow!==!0&&this.type===gs&&M(H,y),H.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(k,L,D)};function M(b,g){const y=t.update(S);u.defines.VSM_SAMPLES!==b.blurSamples&&(u.defines.VSM_SAMPLES=b.blurSamples,f.defines.VSM_SAMPLES=b.blurSamples,u.needsUpdate=!0,f.needsUpdate=!0),b.mapPass===null?b.mapPass=new un(s.x,s.y,{format:ii,type:dn}):(b.mapPass.width!==b.map.width||b.mapPass.height!==b.map.height)&&b.mapPass.setSize(b.map.width,b.map.height),u.uniforms.shadow_pass.value=b.map.depthTexture,u.uniforms.resolution.value.set(b.map.width,b.map.height),u.uniforms.radius.value=b.radius,i.setRenderTarget(b.mapPass),i.clear(),i.renderBufferDirect(g,null,y,u,S,null),f.uniforms.shadow_pass.value=b.mapPass.texture,f.uniforms.resolution.value.set(b.map.width,b.map.height),f.uniforms.radius.value=b.radius,i.setRenderTarget(b.map),i.clear(),i.renderBufferDirect(g,null,y,f,S,null)}function A(b,g,y,k){let L=null;const D=y.isPointLight===!0?b.customDistanceMaterial:b.customDepthMaterial;if(D!==void 0)L=D;else if(L=y.isPointLight===!0?l:a,i.localClippingEnabled&&g.clipShadows===!0&&Array.isArray(g.clippingPlanes)&&g.clippingPlanes.length!==0||g.displacementMap&&g.displacementScale!==0||g.alphaMap&&g.alphaTest>0||g.map&&g.alphaTest>0||g.alphaToCoverage===!0){const z=L.uuid,q=g.uuid;let P=c[z];P===void 0&&(P={},c[z]=P);let W=P[q];W===void 0&&(W=L.clone(),P[q]=W,g.addEventListener("dispose",R)),L=W}if(L.visible=g.visible,L.wireframe=g.wireframe,k===gs?L.side=g.shadowSide!==null?g.shadowSide:g.side:L.side=g.shadowSide!==null?g.shadowSide:d[g.side],L.alphaMap=g.alphaMap,L.alphaTest=g.alphaToCoverage===!0?.5:g.alphaTest,L.map=g.map,L.clipShadows=g.clipShadows,L.clippingPlanes=g.clippingPlanes,L.clipIntersection=g.clipIntersection,L.displacementMap=g.displacementMap,L.displacementScale=g.displacementScale,L.displacementBias=g.displacementBias,L.wireframeLinewidth=g.wireframeLinewidth,L.linewidth=g.linewidth,y.isPointLight===!0&&L.isMeshDistanceMaterial===!0){const z=i.properties.get(L);z.light=y}return L}function E(b,g,y,k,L,D){if(b.visible===!1)return;if(b.layers.test(L)&&(b.isMesh||b.isLine||b.isPoints)&&(b.castShadow||b.receiveShadow&&D===gs)&&(!b.frustumCulled||b.intersectsFrustum(n))){b.modelViewMatrix.multiplyMatrices(y.matrixWorldInverse,b.matrixWorld);const P=t.update(b),W=b.material;if(Array.isArray(W)){const Z=P.groups;for(let H=0,et=Z.length;H<et;H++){const V=Z[H],Q=W[V.materialIndex];if(Q&&Q.visible){const j=A(b,Q,k,D);b.onBeforeShadow(i,b,g,y,P,j,V),i.renderBufferDirect(y,null,P,j,b,V),b.onAfterShadow(i,b,g,y,P,j,V)}}}else if(W.visible){const Z=A(b,W,k,D);b.onBeforeShadow(i,b,g,y,P,Z,null),i.renderBufferDirect(y,null,P,Z,b,null),b.onAfterShadow(i,b,g,y,P,Z,null)}}const q=b.children;for(let P=0,W=q.length;P<W;P++)E(q[P],g,y,k,L,D)}function R(b){b.target.removeEventListener("dispose",R);for(const y in c){const k=c[y],L=b.target.uuid;L in k&&(k[L].dispose(),delete k[L])}}}function pv(i,t){function e(){let T=!1;const K=new ce;let G=null;const at=new ce(0,0,0,0);return{setMask:function(it){G!==it&&!T&&(i.colorMask(it,it,it,it),G=it)},setLocked:function(it){T=it},setClear:function(it,rt,Et,Ot,nt){nt===!0&&(it*=Ot,rt*=Ot,Et*=Ot),K.set(it,rt,Et,Ot),at.equals(K)===!1&&(i.clearColor(it,rt,Et,Ot),at.copy(K))},reset:function(){T=!1,G=null,at.set(-1,0,0,0)}}}function n(){let T=!1,K=!1,G=null,at=null,it=null;return{setReversed:function(rt){if(K!==rt){const Et=t.get("EXT_clip_control");rt?Et.clipControlEXT(Et.LOWER_LEFT_EXT,Et.ZERO_TO_ONE_EXT):Et.clipControlEXT(Et.LOWER_LEFT_EXT,Et.NEGATIVE_ONE_TO_ONE_EXT),K=rt;const Ot=it;it=null,this.setClear(Ot)}},getReversed:function(){return K},setTest:function(rt){rt?gt(i.DEPTH_TEST):Nt(i.DEPTH_TEST)},setMask:function(rt){G!==rt&&!T&&(i.depthMask(rt),G=rt)},setFunc:function(rt){if(K&&(rt=Yf[rt]),at!==rt){switch(rt){case Zo:i.depthFunc(i.NEVER);break;case Jo:i.depthFunc(i.ALWAYS);break;case Qo:i.depthFunc(i.LESS);break;case Es:i.depthFunc(i.LEQUAL);break;case jo:i.depthFunc(i.EQUAL);break;case ta:i.depthFunc(i.GEQUAL);break;case ea:i.depthFunc(i.GREATER);break;case na:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}at=rt}},setLocked:function(rt){T=rt},setClear:function(rt){it!==rt&&(it=rt,K&&(rt=1-rt),i.clearDepth(rt))},reset:function(){T=!1,G=null,at=null,it=null,K=!1}}}function s(){let T=!1,K=null,G=null,at=null,it=null,rt=null,Et=null,Ot=null,nt=null;return{setTest:function(bt){T||(bt?gt(i.STENCIL_TEST):Nt(i.STENCIL_TEST))},setMask:function(bt){K!==bt&&!T&&(i.stencilMask(bt),K=bt)},setFunc:function(bt,Ft,ft){(G!==bt||at!==Ft||it!==ft)&&(i.stencilFunc(bt,Ft,ft),G=bt,at=Ft,it=ft)},setOp:function(bt,Ft,ft){(rt!==bt||Et!==Ft||Ot!==ft)&&(i.stencilOp(bt,Ft,ft),rt=bt,Et=Ft,Ot=ft)},setLocked:function(bt){T=bt},setClear:function(bt){nt!==bt&&(i.clearStencil(bt),nt=bt)},reset:function(){T=!1,K=null,G=null,at=null,it=null,rt=null,Et=null,Ot=null,nt=null}}}const r=new e,o=new n,a=new s;let l={};const c=new WeakMap;let h={},d={},u={},f=new WeakMap,v=[],S=null,m=!1,p=null,M=null,A=null,E=null,R=null,b=null,g=null,y=new zt(0,0,0),k=0,L=!1,D=null,z=null,q=null,P=null,W=null;const Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let H=!1,et=0;const V=i.getParameter(i.VERSION);V.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(V)[1]),H=et>=1):V.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(V)[1]),H=et>=2);let Q=null,j={};const wt=i.getParameter(i.SCISSOR_BOX),It=i.getParameter(i.VIEWPORT),Y=new ce().fromArray(wt),mt=new ce().fromArray(It);function xt(T,K,G,at){const it=new Uint8Array(4),rt=i.createTexture();i.bindTexture(T,rt),i.texParameteri(T,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(T,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Et=0;Et<G;Et++)T===i.TEXTURE_3D||T===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,at,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+Et,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return rt}const Tt={};Tt[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),Tt[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Tt[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Tt[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),gt(i.DEPTH_TEST),o.setFunc(Es),Oe(!1),ae(ac),gt(i.CULL_FACE),be(Bi);function gt(T){h[T]!==!0&&(i.enable(T),h[T]=!0)}function Nt(T){h[T]!==!1&&(i.disable(T),h[T]=!1)}function ue(T,K){return u[T]!==K?(i.bindFramebuffer(T,K),u[T]=K,T===i.DRAW_FRAMEBUFFER&&(u[i.FRAMEBUFFER]=K),T===i.FRAMEBUFFER&&(u[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Rt(T,K){let G=v,at=!1;if(T){G=f.get(K),G===void 0&&(G=[],f.set(K,G));const it=T.textures;if(G.length!==it.length||G[0]!==i.COLOR_ATTACHMENT0){for(let rt=0,Et=it.length;rt<Et;rt++)G[rt]=i.COLOR_ATTACHMENT0+rt;G.length=it.length,at=!0}}else G[0]!==i.BACK&&(G[0]=i.BACK,at=!0);at&&i.drawBuffers(G)}function Qt(T){return S!==T?(i.useProgram(T),S=T,!0):!1}const ne={[Fi]:i.FUNC_ADD,[gf]:i.FUNC_SUBTRACT,[_f]:i.FUNC_REVERSE_SUBTRACT};ne[vf]=i.MIN,ne[xf]=i.MAX;const Ht={[Sf]:i.ZERO,[Mf]:i.ONE,[wf]:i.SRC_COLOR,[fu]:i.SRC_ALPHA,[Rf]:i.SRC_ALPHA_SATURATE,[Tf]:i.DST_COLOR,[Ef]:i.DST_ALPHA,[yf]:i.ONE_MINUS_SRC_COLOR,[pu]:i.ONE_MINUS_SRC_ALPHA,[Af]:i.ONE_MINUS_DST_COLOR,[bf]:i.ONE_MINUS_DST_ALPHA,[Cf]:i.CONSTANT_COLOR,[Pf]:i.ONE_MINUS_CONSTANT_COLOR,[Lf]:i.CONSTANT_ALPHA,[If]:i.ONE_MINUS_CONSTANT_ALPHA};function be(T,K,G,at,it,rt,Et,Ot,nt,bt){if(T===Bi){m===!0&&(Nt(i.BLEND),m=!1);return}if(m===!1&&(gt(i.BLEND),m=!0),T!==mf){if(T!==p||bt!==L){if((M!==Fi||R!==Fi)&&(i.blendEquation(i.FUNC_ADD),M=Fi,R=Fi),bt)switch(T){case Ss:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case lc:i.blendFunc(i.ONE,i.ONE);break;case cc:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case hc:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Kt("WebGLState: Invalid blending: ",T);break}else switch(T){case Ss:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case lc:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case cc:Kt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hc:Kt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Kt("WebGLState: Invalid blending: ",T);break}A=null,E=null,b=null,g=null,y.set(0,0,0),k=0,p=T,L=bt}return}it=it||K,rt=rt||G,Et=Et||at,(K!==M||it!==R)&&(i.blendEquationSeparate(ne[K],ne[it]),M=K,R=it),(G!==A||at!==E||rt!==b||Et!==g)&&(i.blendFuncSeparate(Ht[G],Ht[at],Ht[rt],Ht[Et]),A=G,E=at,b=rt,g=Et),(Ot.equals(y)===!1||nt!==k)&&(i.blendColor(Ot.r,Ot.g,Ot.b,nt),y.copy(Ot),k=nt),p=T,L=!1}function ge(T,K){T.side===xn?Nt(i.CULL_FACE):gt(i.CULL_FACE);let G=T.side===ke;K&&(G=!G),Oe(G),T.blending===Ss&&T.transparent===!1?be(Bi):be(T.blending,T.blendEquation,T.blendSrc,T.blendDst,T.blendEquationAlpha,T.blendSrcAlpha,T.blendDstAlpha,T.blendColor,T.blendAlpha,T.premultipliedAlpha),o.setFunc(T.depthFunc),o.setTest(T.depthTest),o.setMask(T.depthWrite),r.setMask(T.colorWrite);const at=T.stencilWrite;a.setTest(at),at&&(a.setMask(T.stencilWriteMask),a.setFunc(T.stencilFunc,T.stencilRef,T.stencilFuncMask),a.setOp(T.stencilFail,T.stencilZFail,T.stencilZPass)),Se(T.polygonOffset,T.polygonOffsetFactor,T.polygonOffsetUnits),T.alphaToCoverage===!0?gt(i.SAMPLE_ALPHA_TO_COVERAGE):Nt(i.SAMPLE_ALPHA_TO_COVERAGE)}function Oe(T){D!==T&&(T?i.frontFace(i.CW):i.frontFace(i.CCW),D=T)}function ae(T){T!==df?(gt(i.CULL_FACE),T!==z&&(T===ac?i.cullFace(i.BACK):T===ff?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Nt(i.CULL_FACE),z=T}function fn(T){T!==q&&(H&&i.lineWidth(T),q=T)}function Se(T,K,G){T?(gt(i.POLYGON_OFFSET_FILL),(P!==K||W!==G)&&(P=K,W=G,o.getReversed()&&(K=-K,G=-G),i.polygonOffset(K,G))):Nt(i.POLYGON_OFFSET_FILL)}function Ve(T){T?gt(i.SCISSOR_TEST):Nt(i.SCISSOR_TEST)}function We(T){T===void 0&&(T=i.TEXTURE0+Z-1),Q!==T&&(i.activeTexture(T),Q=T)}function Xe(T,K,G){G===void 0&&(Q===null?G=i.TEXTURE0+Z-1:G=Q);let at=j[G];at===void 0&&(at={type:void 0,texture:void 0},j[G]=at),(at.type!==T||at.texture!==K)&&(Q!==G&&(i.activeTexture(G),Q=G),i.bindTexture(T,K||Tt[T]),at.type=T,at.texture=K)}function I(){const T=j[Q];T!==void 0&&T.type!==void 0&&(i.bindTexture(T.type,null),T.type=void 0,T.texture=void 0)}function qe(){try{i.compressedTexImage2D(...arguments)}catch(T){Kt("WebGLState:",T)}}function re(){try{i.compressedTexImage3D(...arguments)}catch(T){Kt("WebGLState:",T)}}function oe(){try{i.texSubImage2D(...arguments)}catch(T){Kt("WebGLState:",T)}}function ut(){try{i.texSubImage3D(...arguments)}catch(T){Kt("WebGLState:",T)}}function _e(){try{i.compressedTexSubImage2D(...arguments)}catch(T){Kt("WebGLState:",T)}}function At(){try{i.compressedTexSubImage3D(...arguments)}catch(T){Kt("WebGLState:",T)}}function Pt(){try{i.texStorage2D(...arguments)}catch(T){Kt("WebGLState:",T)}}function w(){try{i.texStorage3D(...arguments)}catch(T){Kt("WebGLState:",T)}}function _(){try{i.texImage2D(...arguments)}catch(T){Kt("WebGLState:",T)}}function F(){try{i.texImage3D(...arguments)}catch(T){Kt("WebGLState:",T)}}function tt(T){return d[T]!==void 0?d[T]:i.getParameter(T)}function J(T,K){d[T]!==K&&(i.pixelStorei(T,K),d[T]=K)}function st(T){Y.equals(T)===!1&&(i.scissor(T.x,T.y,T.z,T.w),Y.copy(T))}function ct(T){mt.equals(T)===!1&&(i.viewport(T.x,T.y,T.z,T.w),mt.copy(T))}function X(T,K){let G=c.get(K);G===void 0&&(G=new WeakMap,c.set(K,G));let at=G.get(T);at===void 0&&(at=i.getUniformBlockIndex(K,T.name),i.uniformBlockBinding(K,at,at),G.set(T,at))}function $(T,K,G){const it=c.get(K).get(T);l[it]!==G&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,G),l[it]=G)}function ot(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},d={},Q=null,j={},u={},l={},f=new WeakMap,v=[],S=null,m=!1,p=null,M=null,A=null,E=null,R=null,b=null,g=null,y=new zt(0,0,0),k=0,L=!1,D=null,z=null,q=null,P=null,W=null,Y.set(0,0,i.canvas.width,i.canvas.height),mt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:gt,disable:Nt,bindFramebuffer:ue,drawBuffers:Rt,useProgram:Qt,setBlending:be,setMaterial:ge,setFlipSided:Oe,setCullFace:ae,setLineWidth:fn,setPolygonOffset:Se,setScissorTest:Ve,activeTexture:We,bindTexture:Xe,unbindTexture:I,compressedTexImage2D:qe,compressedTexImage3D:re,texImage2D:_,texImage3D:F,pixelStorei:J,getParameter:tt,updateUBOMapping:X,uniformBlockBinding:$,texStorage2D:Pt,texStorage3D:w,texSubImage2D:oe,texSubImage3D:ut,compressedTexSubImage2D:_e,compressedTexSubImage3D:At,scissor:st,viewport:ct,reset:ot}}function mv(i,t,e,n,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new $t,h=new WeakMap,d=new Set;let u;const f=new WeakMap,v=new Set,S=new FinalizationRegistry(w=>v.delete(w));let m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(w,_){return m?new OffscreenCanvas(w,_):Nr("canvas")}function M(w,_,F){let tt=1;const J=Pt(w);if((J.width>F||J.height>F)&&(tt=F/Math.max(J.width,J.height)),tt<1)if(typeof HTMLImageElement<"u"&&w instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&w instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&w instanceof ImageBitmap||typeof VideoFrame<"u"&&w instanceof VideoFrame){const st=Math.floor(tt*J.width),ct=Math.floor(tt*J.height);u===void 0&&(u=p(st,ct));const X=_?p(st,ct):u;return X.width=st,X.height=ct,X.getContext("2d").drawImage(w,0,0,st,ct),Ct("WebGLRenderer: Texture has been resized from ("+J.width+"x"+J.height+") to ("+st+"x"+ct+")."),X}else return"data"in w&&Ct("WebGLRenderer: Image in DataTexture is too big ("+J.width+"x"+J.height+")."),w;return w}function A(w){return w.generateMipmaps}function E(w){i.generateMipmap(w)}function R(w){return w.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:w.isWebGL3DRenderTarget?i.TEXTURE_3D:w.isWebGLArrayRenderTarget||w.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function b(w,_,F,tt,J,st=!1){if(w!==null){if(i[w]!==void 0)return i[w];Ct("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+w+"'")}let ct;tt&&(ct=t.get("EXT_texture_norm16"),ct||Ct("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let X=_;if(_===i.RED&&(F===i.FLOAT&&(X=i.R32F),F===i.HALF_FLOAT&&(X=i.R16F),F===i.UNSIGNED_BYTE&&(X=i.R8),F===i.UNSIGNED_SHORT&&ct&&(X=ct.R16_EXT),F===i.SHORT&&ct&&(X=ct.R16_SNORM_EXT)),_===i.RED_INTEGER&&(F===i.UNSIGNED_BYTE&&(X=i.R8UI),F===i.UNSIGNED_SHORT&&(X=i.R16UI),F===i.UNSIGNED_INT&&(X=i.R32UI),F===i.BYTE&&(X=i.R8I),F===i.SHORT&&(X=i.R16I),F===i.INT&&(X=i.R32I)),_===i.RG&&(F===i.FLOAT&&(X=i.RG32F),F===i.HALF_FLOAT&&(X=i.RG16F),F===i.UNSIGNED_BYTE&&(X=i.RG8),F===i.UNSIGNED_SHORT&&ct&&(X=ct.RG16_EXT),F===i.SHORT&&ct&&(X=ct.RG16_SNORM_EXT)),_===i.RG_INTEGER&&(F===i.UNSIGNED_BYTE&&(X=i.RG8UI),F===i.UNSIGNED_SHORT&&(X=i.RG16UI),F===i.UNSIGNED_INT&&(X=i.RG32UI),F===i.BYTE&&(X=i.RG8I),F===i.SHORT&&(X=i.RG16I),F===i.INT&&(X=i.RG32I)),_===i.RGB_INTEGER&&(F===i.UNSIGNED_BYTE&&(X=i.RGB8UI),F===i.UNSIGNED_SHORT&&(X=i.RGB16UI),F===i.UNSIGNED_INT&&(X=i.RGB32UI),F===i.BYTE&&(X=i.RGB8I),F===i.SHORT&&(X=i.RGB16I),F===i.INT&&(X=i.RGB32I)),_===i.RGBA_INTEGER&&(F===i.UNSIGNED_BYTE&&(X=i.RGBA8UI),F===i.UNSIGNED_SHORT&&(X=i.RGBA16UI),F===i.UNSIGNED_INT&&(X=i.RGBA32UI),F===i.BYTE&&(X=i.RGBA8I),F===i.SHORT&&(X=i.RGBA16I),F===i.INT&&(X=i.RGBA32I)),_===i.RGB&&(F===i.UNSIGNED_SHORT&&ct&&(X=ct.RGB16_EXT),F===i.SHORT&&ct&&(X=ct.RGB16_SNORM_EXT),F===i.UNSIGNED_INT_5_9_9_9_REV&&(X=i.RGB9_E5),F===i.UNSIGNED_INT_10F_11F_11F_REV&&(X=i.R11F_G11F_B10F)),_===i.RGBA){const $=st?Ir:Xt.getTransfer(J);F===i.FLOAT&&(X=i.RGBA32F),F===i.HALF_FLOAT&&(X=i.RGBA16F),F===i.UNSIGNED_BYTE&&(X=$===te?i.SRGB8_ALPHA8:i.RGBA8),F===i.UNSIGNED_SHORT&&ct&&(X=ct.RGBA16_EXT),F===i.SHORT&&ct&&(X=ct.RGBA16_SNORM_EXT),F===i.UNSIGNED_SHORT_4_4_4_4&&(X=i.RGBA4),F===i.UNSIGNED_SHORT_5_5_5_1&&(X=i.RGB5_A1)}return(X===i.R16F||X===i.R32F||X===i.RG16F||X===i.RG32F||X===i.RGBA16F||X===i.RGBA32F)&&t.get("EXT_color_buffer_float"),X}function g(w,_){let F;return w?_===null||_===tn||_===Wi?F=i.DEPTH24_STENCIL8:_===Je?F=i.DEPTH32F_STENCIL8:_===Ts&&(F=i.DEPTH24_STENCIL8,Ct("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):_===null||_===tn||_===Wi?F=i.DEPTH_COMPONENT24:_===Je?F=i.DEPTH_COMPONENT32F:_===Ts&&(F=i.DEPTH_COMPONENT16),F}function y(w,_){return A(w)===!0||w.isFramebufferTexture&&w.minFilter!==me&&w.minFilter!==Ie?Math.log2(Math.max(_.width,_.height))+1:w.mipmaps.length>0?w.mipmaps.length:w.isCompressedTexture&&Array.isArray(w.image)?_.mipmaps.length:1}function k(w){const _=new WeakRef(w);n.get(w).__ref=_,v.add(_),S.register(w,_,_)}function L(w){const _=n.get(w).__ref;_!==void 0&&(v.delete(_),S.unregister(_))}function D(w){q(w.target)}function z(w){P(w.target)}function q(w){w.removeEventListener("dispose",D),L(w),Z(w),w.isVideoTexture&&h.delete(w),w.isHTMLTexture&&d.delete(w)}function P(w){w.removeEventListener("dispose",z),L(w),et(w)}function W(){for(const w of v){const _=w.deref();_!==void 0&&(_.isRenderTarget===!0?P(_):q(_))}v.clear(),d.clear()}function Z(w){const _=n.get(w);if(_.__webglInit===void 0)return;const F=w.source,tt=f.get(F);if(tt){const J=tt[_.__cacheKey];J.usedTimes--,J.usedTimes===0&&H(w),Object.keys(tt).length===0&&f.delete(F)}n.remove(w)}function H(w){const _=n.get(w);i.deleteTexture(_.__webglTexture);const F=w.source,tt=f.get(F);delete tt[_.__cacheKey],o.memory.textures--}function et(w){const _=n.get(w);_.__depthDisposeCallback&&_.__depthDisposeCallback();const F=w.depthTexture;if(F&&F.renderTarget===w&&q(F),w.isWebGLCubeRenderTarget)for(let J=0;J<6;J++){if(Array.isArray(_.__webglFramebuffer[J]))for(let st=0;st<_.__webglFramebuffer[J].length;st++)i.deleteFramebuffer(_.__webglFramebuffer[J][st]);else i.deleteFramebuffer(_.__webglFramebuffer[J]);_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer[J])}else{if(Array.isArray(_.__webglFramebuffer))for(let J=0;J<_.__webglFramebuffer.length;J++)i.deleteFramebuffer(_.__webglFramebuffer[J]);else i.deleteFramebuffer(_.__webglFramebuffer);if(_.__webglDepthbuffer&&i.deleteRenderbuffer(_.__webglDepthbuffer),_.__webglMultisampledFramebuffer&&i.deleteFramebuffer(_.__webglMultisampledFramebuffer),_.__webglColorRenderbuffer)for(let J=0;J<_.__webglColorRenderbuffer.length;J++)_.__webglColorRenderbuffer[J]&&i.deleteRenderbuffer(_.__webglColorRenderbuffer[J]);_.__webglDepthRenderbuffer&&i.deleteRenderbuffer(_.__webglDepthRenderbuffer)}const tt=w.textures;for(let J=0,st=tt.length;J<st;J++){const ct=n.get(tt[J]);ct.__webglTexture&&(i.deleteTexture(ct.__webglTexture),o.memory.textures--),n.remove(tt[J])}n.remove(w)}let V=0;function Q(){V=0}function j(){return V}function wt(w){V=w}function It(){const w=V;return w>=s.maxTextures&&Ct("WebGLTextures: Trying to use "+(w+1)+" texture units while this GPU supports only "+s.maxTextures),V+=1,w}function Y(w){const _=[];return _.push(w.wrapS),_.push(w.wrapT),_.push(w.wrapR||0),_.push(w.magFilter),_.push(w.minFilter),_.push(w.anisotropy),_.push(w.internalFormat),_.push(w.format),_.push(w.type),_.push(w.generateMipmaps),_.push(w.mipmapsAutoUpdate),_.push(w.premultiplyAlpha),_.push(w.flipY),_.push(w.unpackAlignment),_.push(w.colorSpace),_.join()}function mt(w,_){const F=n.get(w);if(w.isVideoTexture&&_e(w),w.isRenderTargetTexture===!1&&w.isExternalTexture!==!0&&w.version>0&&F.__version!==w.version){const tt=w.image;if(tt===null)Ct("WebGLRenderer: Texture marked for update but no image data found.");else if(tt.complete===!1)Ct("WebGLRenderer: Texture marked for update but image is incomplete");else{ge(F,w,_);return}}else w.isExternalTexture&&(F.__webglTexture=w.sourceTexture?w.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,F.__webglTexture,i.TEXTURE0+_)}function xt(w,_){const F=n.get(w);if(w.isRenderTargetTexture===!1&&w.version>0&&F.__version!==w.version){ge(F,w,_);return}else w.isExternalTexture&&(F.__webglTexture=w.sourceTexture?w.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,F.__webglTexture,i.TEXTURE0+_)}function Tt(w,_){const F=n.get(w);if(w.isRenderTargetTexture===!1&&w.version>0&&F.__version!==w.version){ge(F,w,_);return}e.bindTexture(i.TEXTURE_3D,F.__webglTexture,i.TEXTURE0+_)}function gt(w,_){const F=n.get(w);if(w.version>0&&F.__version!==w.version){Oe(F,w,_);return}e.bindTexture(i.TEXTURE_CUBE_MAP,F.__webglTexture,i.TEXTURE0+_)}const Nt={[Rr]:i.REPEAT,[kn]:i.CLAMP_TO_EDGE,[ia]:i.MIRRORED_REPEAT},ue={[me]:i.NEAREST,[Uf]:i.NEAREST_MIPMAP_NEAREST,[Us]:i.NEAREST_MIPMAP_LINEAR,[Ie]:i.LINEAR,[ao]:i.LINEAR_MIPMAP_NEAREST,[Qn]:i.LINEAR_MIPMAP_LINEAR},Rt={[Bf]:i.NEVER,[Iu]:i.ALWAYS,[zf]:i.LESS,[fl]:i.LEQUAL,[Hf]:i.EQUAL,[Lu]:i.GEQUAL,[Gf]:i.GREATER,[Vf]:i.NOTEQUAL};function Qt(w,_){if(_.type===Je&&t.has("OES_texture_float_linear")===!1&&(_.magFilter===Ie||_.magFilter===ao||_.magFilter===Us||_.magFilter===Qn||_.minFilter===Ie||_.minFilter===ao||_.minFilter===Us||_.minFilter===Qn)&&Ct("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(w,i.TEXTURE_WRAP_S,Nt[_.wrapS]),i.texParameteri(w,i.TEXTURE_WRAP_T,Nt[_.wrapT]),(w===i.TEXTURE_3D||w===i.TEXTURE_2D_ARRAY)&&i.texParameteri(w,i.TEXTURE_WRAP_R,Nt[_.wrapR]),i.texParameteri(w,i.TEXTURE_MAG_FILTER,ue[_.magFilter]),i.texParameteri(w,i.TEXTURE_MIN_FILTER,ue[_.minFilter]),_.compareFunction&&(i.texParameteri(w,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(w,i.TEXTURE_COMPARE_FUNC,Rt[_.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(_.magFilter===me||_.minFilter!==Us&&_.minFilter!==Qn||_.type===Je&&t.has("OES_texture_float_linear")===!1)return;if(_.anisotropy>1||n.get(_).__currentAnisotropy){const F=t.get("EXT_texture_filter_anisotropic");i.texParameterf(w,F.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(_.anisotropy,s.getMaxAnisotropy())),n.get(_).__currentAnisotropy=_.anisotropy}}}function ne(w,_){let F=!1;w.__webglInit===void 0&&(w.__webglInit=!0,_.addEventListener("dispose",D),k(_));const tt=_.source;let J=f.get(tt);J===void 0&&(J={},f.set(tt,J));const st=Y(_);if(st!==w.__cacheKey){J[st]===void 0&&(J[st]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,F=!0),J[st].usedTimes++;const ct=J[w.__cacheKey];ct!==void 0&&(J[w.__cacheKey].usedTimes--,ct.usedTimes===0&&H(_)),w.__cacheKey=st,w.__webglTexture=J[st].texture}return F}function Ht(w,_,F){return Math.floor(Math.floor(w/F)/_)}function be(w,_,F,tt){const st=w.updateRanges;if(st.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,_.width,_.height,F,tt,_.data);else{st.sort((T,K)=>T.start-K.start);let ct=0;for(let T=1;T<st.length;T++){const K=st[ct],G=st[T],at=K.start+K.count,it=Ht(G.start,_.width,4),rt=Ht(K.start,_.width,4);G.start<=at+1&&it===rt&&Ht(G.start+G.count-1,_.width,4)===it?K.count=Math.max(K.count,G.start+G.count-K.start):(++ct,st[ct]=G)}st.length=ct+1;const X=e.getParameter(i.UNPACK_ROW_LENGTH),$=e.getParameter(i.UNPACK_SKIP_PIXELS),ot=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,_.width);for(let T=0,K=st.length;T<K;T++){const G=st[T],at=Math.floor(G.start/4),it=Math.ceil(G.count/4),rt=at%_.width,Et=Math.floor(at/_.width),Ot=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,rt),e.pixelStorei(i.UNPACK_SKIP_ROWS,Et),e.texSubImage2D(i.TEXTURE_2D,0,rt,Et,Ot,nt,F,tt,_.data)}w.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,X),e.pixelStorei(i.UNPACK_SKIP_PIXELS,$),e.pixelStorei(i.UNPACK_SKIP_ROWS,ot)}}function ge(w,_,F){let tt=i.TEXTURE_2D;(_.isDataArrayTexture||_.isCompressedArrayTexture)&&(tt=i.TEXTURE_2D_ARRAY),_.isData3DTexture&&(tt=i.TEXTURE_3D);const J=ne(w,_),st=_.source;e.bindTexture(tt,w.__webglTexture,i.TEXTURE0+F);const ct=n.get(st);if(st.version!==ct.__version||J===!0){if(e.activeTexture(i.TEXTURE0+F),(typeof ImageBitmap<"u"&&_.image instanceof ImageBitmap)===!1){const nt=Xt.getPrimaries(Xt.workingColorSpace),bt=_.colorSpace===Nn?null:Xt.getPrimaries(_.colorSpace),Ft=_.colorSpace===Nn||nt===bt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ft)}e.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment);let $=M(_.image,!1,s.maxTextureSize);$=At(_,$);const ot=r.convert(_.format,_.colorSpace),T=r.convert(_.type);let K=b(_.internalFormat,ot,T,_.normalized,_.colorSpace,_.isVideoTexture);Qt(tt,_);let G;const at=_.mipmaps,it=_.isVideoTexture!==!0,rt=ct.__version===void 0||J===!0,Et=st.dataReady,Ot=y(_,$);if(_.isDepthTexture)K=g(_.format===jn,_.type),rt&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,$.width,$.height):e.texImage2D(i.TEXTURE_2D,0,K,$.width,$.height,0,ot,T,null));else if(_.isDataTexture)if(at.length>0){it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,at[0].width,at[0].height);for(let nt=0,bt=at.length;nt<bt;nt++)G=at[nt],it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,G.width,G.height,ot,T,G.data):e.texImage2D(i.TEXTURE_2D,nt,K,G.width,G.height,0,ot,T,G.data);_.generateMipmaps=!1}else it?(rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,$.width,$.height),Et&&be(_,$,ot,T)):e.texImage2D(i.TEXTURE_2D,0,K,$.width,$.height,0,ot,T,$.data);else if(_.isCompressedTexture)if(_.isCompressedArrayTexture){it&&rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,at[0].width,at[0].height,$.depth);for(let nt=0,bt=at.length;nt<bt;nt++)if(G=at[nt],_.format!==Qe)if(ot!==null)if(it){if(Et)if(_.layerUpdates.size>0){const Ft=Ic(G.width,G.height,_.format,_.type);for(const ft of _.layerUpdates){const jt=G.data.subarray(ft*Ft/G.data.BYTES_PER_ELEMENT,(ft+1)*Ft/G.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,ft,G.width,G.height,1,ot,jt)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,G.width,G.height,$.depth,ot,G.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,G.width,G.height,$.depth,0,G.data,0,0);else Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?Et&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,G.width,G.height,$.depth,ot,T,G.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,G.width,G.height,$.depth,0,ot,T,G.data);_.layerUpdates.size>0&&_.clearLayerUpdates()}else{it&&rt&&e.texStorage2D(i.TEXTURE_2D,Ot,K,at[0].width,at[0].height);for(let nt=0,bt=at.length;nt<bt;nt++)G=at[nt],_.format!==Qe?ot!==null?it?Et&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,G.width,G.height,ot,G.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,G.width,G.height,0,G.data):Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,G.width,G.height,ot,T,G.data):e.texImage2D(i.TEXTURE_2D,nt,K,G.width,G.height,0,ot,T,G.data)}else if(_.isDataArrayTexture)if(it){if(rt&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Ot,K,$.width,$.height,$.depth),Et)if(_.layerUpdates.size>0){const nt=Ic($.width,$.height,_.format,_.type);for(const bt of _.layerUpdates){const Ft=$.data.subarray(bt*nt/$.data.BYTES_PER_ELEMENT,(bt+1)*nt/$.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,bt,$.width,$.height,1,ot,T,Ft)}_.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,$.width,$.height,$.depth,ot,T,$.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,$.width,$.height,$.depth,0,ot,T,$.data);else if(_.isData3DTexture)it?(rt&&e.texStorage3D(i.TEXTURE_3D,Ot,K,$.width,$.height,$.depth),Et&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,$.width,$.height,$.depth,ot,T,$.data)):e.texImage3D(i.TEXTURE_3D,0,K,$.width,$.height,$.depth,0,ot,T,$.data);else if(_.isFramebufferTexture){if(rt)if(it)e.texStorage2D(i.TEXTURE_2D,Ot,K,$.width,$.height);else{let nt=$.width,bt=$.height;for(let Ft=0;Ft<Ot;Ft++)e.texImage2D(i.TEXTURE_2D,Ft,K,nt,bt,0,ot,T,null),nt>>=1,bt>>=1}}else if(_.isHTMLTexture){if("texElementImage2D"in i){const nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),$.parentNode!==nt){nt.appendChild($),d.add(_),nt.onpaint=bt=>{const Ft=bt.changedElements;for(const ft of d)Ft.includes(ft.image)&&(ft.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,$);else{const Ft=i.RGBA,ft=i.RGBA,jt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ft,ft,jt,$)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(at.length>0){if(it&&rt){const nt=Pt(at[0]);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}for(let nt=0,bt=at.length;nt<bt;nt++)G=at[nt],it?Et&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,ot,T,G):e.texImage2D(i.TEXTURE_2D,nt,K,ot,T,G);_.generateMipmaps=!1}else if(it){if(rt){const nt=Pt($);e.texStorage2D(i.TEXTURE_2D,Ot,K,nt.width,nt.height)}Et&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ot,T,$)}else e.texImage2D(i.TEXTURE_2D,0,K,ot,T,$);A(_)&&_.mipmapsAutoUpdate===!0&&E(tt),ct.__version=st.version,_.onUpdate&&_.onUpdate(_)}w.__version=_.version}function Oe(w,_,F){if(_.image.length!==6)return;const tt=ne(w,_),J=_.source;e.bindTexture(i.TEXTURE_CUBE_MAP,w.__webglTexture,i.TEXTURE0+F);const st=n.get(J);if(J.version!==st.__version||tt===!0){e.activeTexture(i.TEXTURE0+F);const ct=Xt.getPrimaries(Xt.workingColorSpace),X=_.colorSpace===Nn?null:Xt.getPrimaries(_.colorSpace),$=_.colorSpace===Nn||ct===X?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,_.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,_.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,_.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,$);const ot=_.isCompressedTexture||_.image[0].isCompressedTexture,T=_.image[0]&&_.image[0].isDataTexture,K=[];for(let ft=0;ft<6;ft++)!ot&&!T?K[ft]=M(_.image[ft],!0,s.maxCubemapSize):K[ft]=T?_.image[ft].image:_.image[ft],K[ft]=At(_,K[ft]);const G=K[0],at=r.convert(_.format,_.colorSpace),it=r.convert(_.type);let rt=b(_.internalFormat,at,it,_.normalized,_.colorSpace);const Et=_.isVideoTexture!==!0,Ot=st.__version===void 0||tt===!0,nt=J.dataReady;let bt=y(_,G);Qt(i.TEXTURE_CUBE_MAP,_);let Ft;if(_.isDepthTexture){if(rt=g(_.format===jn,_.type),Ot)if(Et)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,rt,G.width,G.height);else for(let ft=0;ft<6;ft++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,rt,G.width,G.height,0,at,it,null)}else if(ot){Et&&Ot&&e.texStorage2D(i.TEXTURE_CUBE_MAP,bt,rt,G.width,G.height);for(let ft=0;ft<6;ft++){Ft=K[ft].mipmaps;for(let jt=0;jt<Ft.length;jt++){const Me=Ft[jt];_.format!==Qe?at!==null?Et?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,jt,0,0,Me.width,Me.height,at,Me.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,jt,rt,Me.width,Me.height,0,Me.data):Ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,jt,0,0,Me.width,Me.height,at,it,Me.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,jt,rt,Me.width,Me.height,0,at,it,Me.data)}}}else{if(Ft=_.mipmaps,Et&&Ot){Ft.length>0&&bt++;const ft=Pt(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,bt,rt,ft.width,ft.height)}for(let ft=0;ft<6;ft++)if(T){Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,0,0,K[ft].width,K[ft].height,at,it,K[ft].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,rt,K[ft].width,K[ft].height,0,at,it,K[ft].data);for(let jt=0;jt<Ft.length;jt++){const Gn=Ft[jt].image[ft].image;Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,jt+1,0,0,Gn.width,Gn.height,at,it,Gn.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,jt+1,rt,Gn.width,Gn.height,0,at,it,Gn.data)}}else{Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,0,0,at,it,K[ft]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,rt,at,it,K[ft]);for(let jt=0;jt<Ft.length;jt++){const Me=Ft[jt];Et?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,jt+1,0,0,at,it,Me.image[ft]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+ft,jt+1,rt,at,it,Me.image[ft])}}}A(_)&&_.mipmapsAutoUpdate===!0&&E(i.TEXTURE_CUBE_MAP),st.__version=J.version,_.onUpdate&&_.onUpdate(_)}w.__version=_.version}function ae(w,_,F,tt,J,st){const ct=r.convert(F.format,F.colorSpace),X=r.convert(F.type),$=b(F.internalFormat,ct,X,F.normalized,F.colorSpace),ot=n.get(_),T=n.get(F);if(T.__renderTarget=_,!ot.__hasExternalTextures){const K=Math.max(1,_.width>>st),G=Math.max(1,_.height>>st);J===i.TEXTURE_3D||J===i.TEXTURE_2D_ARRAY?e.texImage3D(J,st,$,K,G,_.depth,0,ct,X,null):e.texImage2D(J,st,$,K,G,0,ct,X,null)}e.bindFramebuffer(i.FRAMEBUFFER,w),ut(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,tt,J,T.__webglTexture,0,oe(_)):(J===i.TEXTURE_2D||J>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&J<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,tt,J,T.__webglTexture,st),e.bindFramebuffer(i.FRAMEBUFFER,null)}function fn(w,_,F){if(i.bindRenderbuffer(i.RENDERBUFFER,w),_.depthBuffer){const tt=_.depthTexture,J=tt&&tt.isDepthTexture?tt.type:null,st=g(_.stencilBuffer,J),ct=_.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;ut(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,oe(_),st,_.width,_.height):F?i.renderbufferStorageMultisample(i.RENDERBUFFER,oe(_),st,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,st,_.width,_.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ct,i.RENDERBUFFER,w)}else{const tt=_.textures;for(let J=0;J<tt.length;J++){const st=tt[J],ct=r.convert(st.format,st.colorSpace),X=r.convert(st.type),$=b(st.internalFormat,ct,X,st.normalized,st.colorSpace);ut(_)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,oe(_),$,_.width,_.height):F?i.renderbufferStorageMultisample(i.RENDERBUFFER,oe(_),$,_.width,_.height):i.renderbufferStorage(i.RENDERBUFFER,$,_.width,_.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Se(w,_,F){const tt=_.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,w),!(_.depthTexture&&_.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");const J=n.get(_.depthTexture);J.__renderTarget=_;const st=tt?_.depthTexture.image[0]:_.depthTexture.image;(!J.__webglTexture||st.width!==_.width||st.height!==_.height)&&(st.width=_.width,st.height=_.height,_.depthTexture.needsUpdate=!0),tt?gt(_.depthTexture,0):mt(_.depthTexture,0);const ct=J.__webglTexture,X=oe(_),$=tt?i.TEXTURE_CUBE_MAP_POSITIVE_X+F:i.TEXTURE_2D,ot=_.depthTexture.format===jn?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(_.depthTexture.format===ni)ut(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ot,$,ct,0,X):i.framebufferTexture2D(i.FRAMEBUFFER,ot,$,ct,0);else if(_.depthTexture.format===jn)ut(_)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ot,$,ct,0,X):i.framebufferTexture2D(i.FRAMEBUFFER,ot,$,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ve(w){const _=n.get(w),F=w.isWebGLCubeRenderTarget===!0;if(_.__boundDepthTexture!==w.depthTexture){const tt=w.depthTexture;if(_.__depthDisposeCallback&&_.__depthDisposeCallback(),tt){const J=()=>{delete _.__boundDepthTexture,delete _.__depthDisposeCallback,tt.removeEventListener("dispose",J)};tt.addEventListener("dispose",J),_.__depthDisposeCallback=J}_.__boundDepthTexture=tt}if(w.depthTexture&&!_.__autoAllocateDepthBuffer)if(F)for(let tt=0;tt<6;tt++)Se(_.__webglFramebuffer[tt],w,tt);else w.texture.mipmaps.length>0?Se(_.__webglFramebuffer[0],w,0):Se(_.__webglFramebuffer,w,0);else if(F){_.__webglDepthbuffer=[];for(let tt=0;tt<6;tt++)if(e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[tt]),_.__webglDepthbuffer[tt]===void 0)_.__webglDepthbuffer[tt]=i.createRenderbuffer(),fn(_.__webglDepthbuffer[tt],w,!1);else{const J=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=_.__webglDepthbuffer[tt];i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,J,i.RENDERBUFFER,st)}}else if(w.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,_.__webglFramebuffer),_.__webglDepthbuffer===void 0)_.__webglDepthbuffer=i.createRenderbuffer(),fn(_.__webglDepthbuffer,w,!1);else{const J=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,st=_.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,st),i.framebufferRenderbuffer(i.FRAMEBUFFER,J,i.RENDERBUFFER,st)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function We(w,_,F){const tt=n.get(w);_!==void 0&&ae(tt.__webglFramebuffer,w,w.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),F!==void 0&&Ve(w)}function Xe(w){const _=w.texture,F=n.get(w),tt=n.get(_);w.addEventListener("dispose",z),k(w);const J=w.textures,st=w.isWebGLCubeRenderTarget===!0,ct=J.length>1;if(ct||(tt.__webglTexture===void 0&&(tt.__webglTexture=i.createTexture()),tt.__version=_.version,o.memory.textures++),st){F.__webglFramebuffer=[];for(let X=0;X<6;X++)if(_.mipmaps.length>0){F.__webglFramebuffer[X]=[];for(let $=0;$<_.mipmaps.length;$++)F.__webglFramebuffer[X][$]=i.createFramebuffer()}else F.__webglFramebuffer[X]=i.createFramebuffer()}else{if(_.mipmaps.length>0){F.__webglFramebuffer=[];for(let X=0;X<_.mipmaps.length;X++)F.__webglFramebuffer[X]=i.createFramebuffer()}else F.__webglFramebuffer=i.createFramebuffer();if(ct)for(let X=0,$=J.length;X<$;X++){const ot=n.get(J[X]);ot.__webglTexture===void 0&&(ot.__webglTexture=i.createTexture(),o.memory.textures++)}if(w.samples>0&&ut(w)===!1){F.__webglMultisampledFramebuffer=i.createFramebuffer(),F.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,F.__webglMultisampledFramebuffer);for(let X=0;X<J.length;X++){const $=J[X];F.__webglColorRenderbuffer[X]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,F.__webglColorRenderbuffer[X]);const ot=r.convert($.format,$.colorSpace),T=r.convert($.type),K=b($.internalFormat,ot,T,$.normalized,$.colorSpace,w.isXRRenderTarget===!0),G=oe(w);i.renderbufferStorageMultisample(i.RENDERBUFFER,G,K,w.width,w.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+X,i.RENDERBUFFER,F.__webglColorRenderbuffer[X])}i.bindRenderbuffer(i.RENDERBUFFER,null),w.depthBuffer&&(F.__webglDepthRenderbuffer=i.createRenderbuffer(),fn(F.__webglDepthRenderbuffer,w,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(st){e.bindTexture(i.TEXTURE_CUBE_MAP,tt.__webglTexture),Qt(i.TEXTURE_CUBE_MAP,_);for(let X=0;X<6;X++)if(_.mipmaps.length>0)for(let $=0;$<_.mipmaps.length;$++)ae(F.__webglFramebuffer[X][$],w,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+X,$);else ae(F.__webglFramebuffer[X],w,_,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+X,0);A(_)?E(i.TEXTURE_CUBE_MAP):_.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let X=0,$=J.length;X<$;X++){const ot=J[X],T=n.get(ot);let K=i.TEXTURE_2D;(w.isWebGL3DRenderTarget||w.isWebGLArrayRenderTarget)&&(K=w.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,T.__webglTexture),Qt(K,ot),ae(F.__webglFramebuffer,w,ot,i.COLOR_ATTACHMENT0+X,K,0),A(ot)&&E(K)}e.unbindTexture()}else{let X=i.TEXTURE_2D;if((w.isWebGL3DRenderTarget||w.isWebGLArrayRenderTarget)&&(X=w.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(X,tt.__webglTexture),Qt(X,_),_.mipmaps.length>0)for(let $=0;$<_.mipmaps.length;$++)ae(F.__webglFramebuffer[$],w,_,i.COLOR_ATTACHMENT0,X,$);else ae(F.__webglFramebuffer,w,_,i.COLOR_ATTACHMENT0,X,0);A(_)?E(X):_.mipmaps.length>0&&i.texParameteri(X,i.TEXTURE_MAX_LEVEL,_.mipmaps.length-1),e.unbindTexture()}w.depthBuffer&&Ve(w)}function I(w){const _=w.textures;for(let F=0,tt=_.length;F<tt;F++){const J=_[F];if(A(J)&&J.mipmapsAutoUpdate===!0){const st=R(w),ct=n.get(J).__webglTexture;e.bindTexture(st,ct),E(st),e.unbindTexture()}}}const qe=[];function re(w){if(w.samples>0){if(ut(w)===!1){const _=w.textures,F=w.width,tt=w.height;let J=i.COLOR_BUFFER_BIT;const st=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ct=n.get(w),X=_.length>1;if(X)for(let ot=0;ot<_.length;ot++)e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ot,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ot,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),w.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let ot=0;ot<_.length;ot++){if(w.resolveDepthBuffer&&(w.depthBuffer&&(J|=i.DEPTH_BUFFER_BIT),w.stencilBuffer&&w.resolveStencilBuffer&&(J|=i.STENCIL_BUFFER_BIT)),X){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ct.__webglColorRenderbuffer[ot]);const T=n.get(_[ot]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,T,0)}i.blitFramebuffer(0,0,F,tt,0,0,F,tt,J,i.NEAREST),l===!0&&(qe.length=0,qe.push(i.COLOR_ATTACHMENT0+ot),w.depthBuffer&&w.storeMultisampledDepthBuffer===!1&&qe.push(st),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,qe))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),X)for(let ot=0;ot<_.length;ot++){e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ot,i.RENDERBUFFER,ct.__webglColorRenderbuffer[ot]);const T=n.get(_[ot]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ct.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ot,i.TEXTURE_2D,T,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(w.depthBuffer&&w.storeMultisampledDepthBuffer===!1&&l){const _=w.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[_])}}}function oe(w){return Math.min(s.maxSamples,w.samples)}function ut(w){const _=n.get(w);return w.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&_.__useRenderToTexture!==!1}function _e(w){const _=o.render.frame;h.get(w)!==_&&(h.set(w,_),w.update())}function At(w,_){const F=w.colorSpace,tt=w.format,J=w.type;return w.isCompressedTexture===!0||w.isVideoTexture===!0||F!==Lr&&F!==Nn&&(Xt.getTransfer(F)===te?(tt!==Qe||J!==Ze)&&Ct("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Kt("WebGLTextures: Unsupported texture color space:",F)),_}function Pt(w){return typeof HTMLImageElement<"u"&&w instanceof HTMLImageElement?(c.width=w.naturalWidth||w.width,c.height=w.naturalHeight||w.height):typeof VideoFrame<"u"&&w instanceof VideoFrame?(c.width=w.displayWidth,c.height=w.displayHeight):(c.width=w.width,c.height=w.height),c}this.allocateTextureUnit=It,this.resetTextureUnits=Q,this.getTextureUnits=j,this.setTextureUnits=wt,this.setTexture2D=mt,this.setTexture2DArray=xt,this.setTexture3D=Tt,this.setTextureCube=gt,this.rebindTextures=We,this.setupRenderTarget=Xe,this.updateRenderTargetMipmap=I,this.updateMultisampleRenderTarget=re,this.setupDepthRenderbuffer=Ve,this.setupFrameBufferTexture=ae,this.useMultisampledRTT=ut,this.dispose=W}function gv(i,t){function e(n,s=Nn){let r;const o=Xt.getTransfer(s);if(n===Ze)return i.UNSIGNED_BYTE;if(n===cl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===hl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Tu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Au)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Eu)return i.BYTE;if(n===bu)return i.SHORT;if(n===Ts)return i.UNSIGNED_SHORT;if(n===ll)return i.INT;if(n===tn)return i.UNSIGNED_INT;if(n===Je)return i.FLOAT;if(n===dn)return i.HALF_FLOAT;if(n===Ru)return i.ALPHA;if(n===Cu)return i.RGB;if(n===Qe)return i.RGBA;if(n===ni)return i.DEPTH_COMPONENT;if(n===jn)return i.DEPTH_STENCIL;if(n===Pu)return i.RED;if(n===ul)return i.RED_INTEGER;if(n===ii)return i.RG;if(n===$r)return i.RG_INTEGER;if(n===dl)return i.RGBA_INTEGER;if(n===vr||n===xr||n===Sr||n===Mr)if(o===te)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===vr)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===xr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Sr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Mr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===vr)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===xr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Sr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Mr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===sa||n===ra||n===oa||n===aa)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===sa)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===ra)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===oa)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===aa)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===la||n===ca||n===ha||n===ua||n===da||n===Cr||n===fa)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===la||n===ca)return o===te?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===ha)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ua)return r.COMPRESSED_R11_EAC;if(n===da)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Cr)return r.COMPRESSED_RG11_EAC;if(n===fa)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===pa||n===ma||n===ga||n===_a||n===va||n===xa||n===Sa||n===Ma||n===wa||n===ya||n===Ea||n===ba||n===Ta||n===Aa)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===pa)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ma)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===ga)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===_a)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===va)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===xa)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Sa)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ma)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===wa)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ya)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Ea)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===ba)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Ta)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Aa)return o===te?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Ra||n===Ca||n===Pa)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Ra)return o===te?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ca)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Pa)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===La||n===Ia||n===Pr||n===Da)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===La)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Ia)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Pr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Da)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Wi?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}const _v=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,vv=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`;class xv{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){const n=new Hu(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new Mi({vertexShader:_v,fragmentShader:vv,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new yn(new Zr(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class Sv extends yi{constructor(t,e){super();const n=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,d=null,u=null,f=null,v=null;const S=typeof XRWebGLBinding<"u",m=new xv,p={},M=e.getContextAttributes();let A=null,E=null;const R=[],b=[],g=new $t;let y=null,k=null;const L=new an;L.viewport=new ce;const D=new an;D.viewport=new ce;const z=[L,D],q=new Ip;let P=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Y){let mt=R[Y];return mt===void 0&&(mt=new _o,R[Y]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(Y){let mt=R[Y];return mt===void 0&&(mt=new _o,R[Y]=mt),mt.getGripSpace()},this.getHand=function(Y){let mt=R[Y];return mt===void 0&&(mt=new _o,R[Y]=mt),mt.getHandSpace()};function Z(Y){const mt=b.indexOf(Y.inputSource);if(mt===-1)return;const xt=R[mt];xt!==void 0&&(xt.update(Y.inputSource,Y.frame,c||o),xt.dispatchEvent({type:Y.type,data:Y.inputSource}))}function H(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",et);for(let Y=0;Y<R.length;Y++){const mt=b[Y];mt!==null&&(b[Y]=null,R[Y].disconnect(mt))}P=null,W=null,m.reset();for(const Y in p)delete p[Y];if(t.setRenderTarget(A),f=null,u=null,d=null,s=null,E=null,It.stop(),n.isPresenting=!1,t.setPixelRatio(y),t.setSize(g.width,g.height,!1),k!==null){const Y=k.camera;Y.fov=k.fov,Y.zoom=k.zoom,Y.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Y){r=Y,n.isPresenting===!0&&Ct("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Y){a=Y,n.isPresenting===!0&&Ct("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Y){c=Y},this.getBaseLayer=function(){return u!==null?u:f},this.getBinding=function(){return d===null&&S&&(d=new XRWebGLBinding(s,e)),d},this.getFrame=function(){return v},this.getSession=function(){return s},this.setSession=async function(Y){if(s=Y,s!==null){if(A=t.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",H),s.addEventListener("inputsourceschange",et),M.xrCompatible!==!0&&await e.makeXRCompatible(),y=t.getPixelRatio(),t.getSize(g),S&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,Tt=null,gt=null;M.depth&&(gt=M.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=M.stencil?jn:ni,Tt=M.stencil?Wi:tn);const Nt={colorFormat:e.RGBA8,depthFormat:gt,scaleFactor:r};d=this.getBinding(),u=d.createProjectionLayer(Nt),s.updateRenderState({layers:[u]}),t.setPixelRatio(1),t.setSize(u.textureWidth,u.textureHeight,!1),E=new un(u.textureWidth,u.textureHeight,{format:Qe,type:Ze,depthTexture:new Si(u.textureWidth,u.textureHeight,Tt,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:M.stencil,colorSpace:t.outputColorSpace,samples:M.antialias?4:0,resolveDepthBuffer:u.ignoreDepthValues===!1,resolveStencilBuffer:u.ignoreDepthValues===!1,storeMultisampledDepthBuffer:u.ignoreDepthValues===!1,storeMultisampledStencilBuffer:u.ignoreDepthValues===!1})}else{const xt={antialias:M.antialias,alpha:!0,depth:M.depth,stencil:M.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),E=new un(f.framebufferWidth,f.framebufferHeight,{format:Qe,type:Ze,colorSpace:t.outputColorSpace,stencilBuffer:M.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}E.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),It.setContext(s),It.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function et(Y){for(let mt=0;mt<Y.removed.length;mt++){const xt=Y.removed[mt],Tt=b.indexOf(xt);Tt>=0&&(b[Tt]=null,R[Tt].disconnect(xt))}for(let mt=0;mt<Y.added.length;mt++){const xt=Y.added[mt];let Tt=b.indexOf(xt);if(Tt===-1){for(let Nt=0;Nt<R.length;Nt++)if(Nt>=b.length){b.push(xt),Tt=Nt;break}else if(b[Nt]===null){b[Nt]=xt,Tt=Nt;break}if(Tt===-1)break}const gt=R[Tt];gt&&gt.connect(xt)}}function V(Y,mt){mt===null?Y.matrixWorld.copy(Y.matrix):Y.matrixWorld.multiplyMatrices(mt.matrixWorld,Y.matrix),Y.matrixWorldInverse.copy(Y.matrixWorld).invert()}this.updateCamera=function(Y){if(s===null)return;let mt=Y.near,xt=Y.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),q.near=D.near=L.near=mt,q.far=D.far=L.far=xt,(P!==q.near||W!==q.far)&&(s.updateRenderState({depthNear:q.near,depthFar:q.far}),P=q.near,W=q.far),q.layers.mask=Y.layers.mask|6,L.layers.mask=q.layers.mask&-5,D.layers.mask=q.layers.mask&-3;const Tt=Y.parent,gt=q.cameras;V(q,Tt);for(let Nt=0;Nt<gt.length;Nt++)V(gt[Nt],Tt);q.projectionMatrix.copy(L.projectionMatrix),q.projectionMatrixInverse.copy(L.projectionMatrixInverse),k===null&&Y.isPerspectiveCamera&&(k={camera:Y,fov:Y.fov,zoom:Y.zoom}),Q(Y,q,Tt)};function Q(Y,mt,xt){xt===null?Y.matrix.copy(mt.matrixWorld):(Y.matrix.copy(xt.matrixWorld),Y.matrix.invert(),Y.matrix.multiply(mt.matrixWorld)),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale),Y.updateMatrixWorld(!0),Y.projectionMatrix.copy(mt.projectionMatrix),Y.projectionMatrixInverse.copy(mt.projectionMatrixInverse),Y.isPerspectiveCamera&&(Y.fov=Na*2*Math.atan(1/Y.projectionMatrix.elements[5]),Y.zoom=1)}this.getCamera=function(){return q},this.getFoveation=function(){if(!(u===null&&f===null))return l},this.setFoveation=function(Y){l=Y,u!==null&&(u.fixedFoveation=Y),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Y)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(q)},this.getCameraTexture=function(Y){return p[Y]};let j=null;function wt(Y,mt){if(h=mt.getViewerPose(c||o),v=mt,h!==null){const xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(E,f.framebuffer),t.setRenderTarget(E));let Tt=!1;xt.length!==q.cameras.length&&(q.cameras.length=0,Tt=!0);for(let Rt=0;Rt<xt.length;Rt++){const Qt=xt[Rt];let ne=null;if(f!==null)ne=f.getViewport(Qt);else{const be=d.getViewSubImage(u,Qt);ne=be.viewport,Rt===0&&(t.setRenderTargetTextures(E,be.colorTexture,be.depthStencilTexture),t.setRenderTarget(E))}let Ht=z[Rt];Ht===void 0&&(Ht=new an,Ht.layers.enable(Rt),Ht.viewport=new ce,z[Rt]=Ht),Ht.matrix.fromArray(Qt.transform.matrix),Ht.matrix.decompose(Ht.position,Ht.quaternion,Ht.scale),Ht.projectionMatrix.fromArray(Qt.projectionMatrix),Ht.projectionMatrixInverse.copy(Ht.projectionMatrix).invert(),Ht.viewport.set(ne.x,ne.y,ne.width,ne.height),Rt===0&&(q.matrix.copy(Ht.matrix),q.matrix.decompose(q.position,q.quaternion,q.scale)),Tt===!0&&q.cameras.push(Ht)}const gt=s.enabledFeatures;if(gt&&gt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&S){d=n.getBinding();const Rt=d.getDepthInformation(xt[0]);Rt&&Rt.isValid&&Rt.texture&&m.init(Rt,s.renderState)}if(gt&&gt.includes("camera-access")&&S){t.state.unbindTexture(),d=n.getBinding();for(let Rt=0;Rt<xt.length;Rt++){const Qt=xt[Rt].camera;if(Qt){let ne=p[Qt];ne||(ne=new Hu,p[Qt]=ne);const Ht=d.getCameraImage(Qt);ne.sourceTexture=Ht}}}}for(let xt=0;xt<R.length;xt++){const Tt=b[xt],gt=R[xt];Tt!==null&&gt!==void 0&&gt.update(Tt,mt,c||o)}j&&j(Y,mt),mt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:mt}),v=null}const It=new Wu;It.setAnimationLoop(wt),this.setAnimationLoop=function(Y){j=Y},this.dispose=function(){}}}const Mv=new Zt,td=new Lt;td.set(-1,0,0,0,1,0,0,0,1);function wv(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Gu(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,M,A,E){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),d(m,p)):p.isMeshPhongMaterial?(r(m,p),h(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),u(m,p),p.isMeshPhysicalMaterial&&f(m,p,E)):p.isMeshMatcapMaterial?(r(m,p),v(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),S(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,M,A):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===ke&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===ke&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const M=t.get(p),A=M.envMap,E=M.envMapRotation;A&&(m.envMap.value=A,m.envMapRotation.value.setFromMatrix4(Mv.makeRotationFromEuler(E)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(td),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,M,A){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*M,m.scale.value=A*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function h(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function d(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function u(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,M){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,e(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===ke&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=M.texture,m.transmissionSamplerSize.value.set(M.width,M.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function v(m,p){p.matcap&&(m.matcap.value=p.matcap)}function S(m,p){const M=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(M.matrixWorld),m.nearDistance.value=M.shadow.camera.near,m.farDistance.value=M.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function yv(i,t,e,n){let s={},r={};function o(M,A){const E=A.program;n.uniformBlockBinding(M,E,s[M.id])}function a(M,A){let E=s[M.id];E===void 0&&(v(M),E=l(M),s[M.id]=E,M.addEventListener("dispose",m));const R=A.program;n.updateUBOMapping(M,R);const b=t.render.frame;r[M.id]!==b&&(c(M),r[M.id]=b)}function l(M){const A=i.createBuffer(),E=M.__size,R=M.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,E,R),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function c(M){const A=s[M.id],E=M.uniforms,R=M.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let b=0,g=E.length;b<g;b++){const y=E[b];if(Array.isArray(y))for(let k=0,L=y.length;k<L;k++)h(y[k],b,k,R);else h(y,b,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(M,A,E,R){if(u(M,A,E,R)===!0){const b=M.__offset,g=M.value;if(Array.isArray(g)){let y=0;for(let k=0;k<g.length;k++){const L=g[k],D=S(L,!0);d(L,M.__data,y),y+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(g,M.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,b,M.__data)}}function d(M,A,E){typeof M=="number"||typeof M=="boolean"?A[E]=M:M.isMatrix3?(A[E]=M.elements[0],A[E+1]=M.elements[1],A[E+2]=M.elements[2],A[E+3]=0,A[E+4]=M.elements[3],A[E+5]=M.elements[4],A[E+6]=M.elements[5],A[E+7]=0,A[E+8]=M.elements[6],A[E+9]=M.elements[7],A[E+10]=M.elements[8],A[E+11]=0):ArrayBuffer.isView(M)?A.set(M.subarray(0,A.length-E),E):M.toArray(A,E)}function u(M,A,E,R){const b=M.value,g=A+"_"+E;if(Array.isArray(b)){R[g]===void 0&&(R[g]=[]);const y=R[g];let k=!1;for(let L=0;L<b.length;L++)f(b[L],y,L)===!0&&(k=!0);return k}return f(b,R,g)}function f(M,A,E){if(A[E]===void 0)return typeof M=="number"||typeof M=="boolean"?A[E]=M:ArrayBuffer.isView(M)?A[E]=M.slice():A[E]=M.clone(),!0;{const R=A[E];if(typeof M=="number"||typeof M=="boolean"){if(R!==M)return A[E]=M,!0}else{if(ArrayBuffer.isView(M))return!0;if(R.equals(M)===!1)return R.copy(M),!0}}return!1}function v(M){const A=M.uniforms;let E=0;const R=16;for(let g=0,y=A.length;g<y;g++){const k=Array.isArray(A[g])?A[g]:[A[g]];for(let L=0,D=k.length;L<D;L++){const z=k[L],q=Array.isArray(z.value)?z.value:[z.value],P=Array.isArray(A[g])||Array.isArray(z.value);let W=E;for(let H=0,et=q.length;H<et;H++){const V=q[H],Q=S(V,P),j=E%R,wt=j%Q.boundary,It=j+wt;E+=wt,It!==0&&R-It<Q.storage&&(E+=R-It),H===0&&(W=E),E+=Q.storage}const Z=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new Z((E-W)/Float32Array.BYTES_PER_ELEMENT),z.__offset=W}}const b=E%R;return b>0&&(E+=R-b),M.__size=E,M.__cache={},this}function S(M,A){const E={boundary:0,storage:0};return typeof M=="number"||typeof M=="boolean"?(E.boundary=4,E.storage=4):M.isVector2?(E.boundary=8,E.storage=8):M.isVector3||M.isColor?(E.boundary=16,E.storage=12):M.isVector4?(E.boundary=16,E.storage=16):M.isMatrix3?(E.boundary=16,E.storage=48):M.isMatrix4?(E.boundary=16,E.storage=64):M.isTexture?Ct("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(M)?(E.boundary=16,E.storage=M.byteLength):Ct("WebGLRenderer: Unsupported uniform value type.",M),A===!0&&(E.boundary=16,E.storage=Math.ceil(E.storage/16)*16),E}function m(M){const A=M.target;A.removeEventListener("dispose",m),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function p(){for(const M in s)i.deleteBuffer(s[M]);s={},r={}}return{bind:o,update:a,dispose:p}}const Ev=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]);let mn=null;function bv(){return mn===null&&(mn=new Kr(Ev,16,16,ii,dn),mn.name="DFG_LUT",mn.minFilter=Ie,mn.magFilter=Ie,mn.wrapS=kn,mn.wrapT=kn,mn.generateMipmaps=!1,mn.needsUpdate=!0),mn}class Tv{constructor(t={}){const{canvas:e=qf(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:u=!1,outputBufferType:f=Ze}=t;this.isWebGLRenderer=!0;let v;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");v=n.getContextAttributes().alpha}else v=o;const S=f,m=new Set([dl,$r,ul]),p=new Set([Ze,tn,Ts,Wi,cl,hl]),M=new Uint32Array(4),A=new Int32Array(4),E={textures:[],min:[],max:[],resolution:[]};let R=null,b=null;const g=[],y=[];let k=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Bn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const L=this;let D=!1,z=null,q=null,P=null,W=null;this._outputColorSpace=Ye;let Z=0,H=0,et=null,V=-1,Q=null;const j=new ce,wt=new ce;let It=null;const Y=new zt(0);let mt=0,xt=e.width,Tt=e.height,gt=1,Nt=null,ue=null;const Rt=new ce(0,0,xt,Tt),Qt=new ce(0,0,xt,Tt);let ne=!1;const Ht=new Ur,be=new vl;let ge=!1,Oe=!1;const ae=new Zt,fn=new U,Se=new ce,Ve={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let We=!1;function Xe(){return et===null?gt:1}let I=n;function qe(x,C){return e.getContext(x,C)}let re,oe,ut,_e,At,Pt,w,_,F,tt,J,st,ct,X,$,ot,T,K,G,at,it,rt,Et;try{const x={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:d};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${al}`),e.addEventListener("webglcontextlost",bt,!1),e.addEventListener("webglcontextrestored",Ft,!1),e.addEventListener("webglcontextcreationerror",ft,!1),I===null){const C="webgl2";if(I=qe(C,x),I===null)throw qe(C)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ot()}catch(x){throw e.removeEventListener("webglcontextlost",bt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",ft,!1),Kt("WebGLRenderer: "+x.message),x}function Ot(){re=new C0(I),re.init(),it=new gv(I,re),oe=new v0(I,re,t,it),ut=new pv(I,re),oe.reversedDepthBuffer&&u&&ut.buffers.depth.setReversed(!0),q=I.createFramebuffer(),P=I.createFramebuffer(),W=I.createFramebuffer(),_e=new I0(I),At=new tv,Pt=new mv(I,re,ut,At,oe,it,_e),w=new R0(L),_=new Np(I),rt=new g0(I,_),F=new P0(I,_,_e,rt),tt=new N0(I,F,_,rt,_e),K=new D0(I,oe,Pt),$=new x0(At),J=new j_(L,w,re,oe,rt,$),st=new wv(L,At),ct=new nv,X=new lv(re),T=new m0(L,w,ut,tt,v,l),ot=new fv(L,tt,oe),Et=new yv(I,_e,oe,ut),G=new _0(I,re,_e),at=new L0(I,re,_e),_e.programs=J.programs,L.capabilities=oe,L.extensions=re,L.properties=At,L.renderLists=ct,L.shadowMap=ot,L.state=ut,L.info=_e}S!==Ze&&(k=new F0(S,e.width,e.height,a,s,r));const nt=new Sv(L,I);this.xr=nt,this.getContext=function(){return I},this.getContextAttributes=function(){return I.getContextAttributes()},this.forceContextLoss=function(){const x=re.get("WEBGL_lose_context");x&&x.loseContext()},this.forceContextRestore=function(){const x=re.get("WEBGL_lose_context");x&&x.restoreContext()},this.getPixelRatio=function(){return gt},this.setPixelRatio=function(x){x!==void 0&&(gt=x,this.setSize(xt,Tt,!1))},this.getSize=function(x){return x.set(xt,Tt)},this.setSize=function(x,C,B=!0){if(nt.isPresenting){Ct("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=x,Tt=C,e.width=Math.floor(x*gt),e.height=Math.floor(C*gt),B===!0&&(e.style.width=x+"px",e.style.height=C+"px"),k!==null&&k.setSize(e.width,e.height),this.setViewport(0,0,x,C)},this.getDrawingBufferSize=function(x){return x.set(xt*gt,Tt*gt).floor()},this.setDrawingBufferSize=function(x,C,B){xt=x,Tt=C,gt=B,e.width=Math.floor(x*B),e.height=Math.floor(C*B),this.setViewport(0,0,x,C)},this.setEffects=function(x){if(S===Ze){Kt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(x){for(let C=0;C<x.length;C++)if(x[C].isOutputPass===!0){Ct("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(x||[])},this.getCurrentViewport=function(x){return x.copy(j)},this.getViewport=function(x){return x.copy(Rt)},this.setViewport=function(x,C,B,N){x.isVector4?Rt.set(x.x,x.y,x.z,x.w):Rt.set(x,C,B,N),ut.viewport(j.copy(Rt).multiplyScalar(Xe()).round())},this.getScissor=function(x){return x.copy(Qt)},this.setScissor=function(x,C,B,N){x.isVector4?Qt.set(x.x,x.y,x.z,x.w):Qt.set(x,C,B,N),ut.scissor(wt.copy(Qt).multiplyScalar(Xe()).round())},this.getScissorTest=function(){return ne},this.setScissorTest=function(x){ut.setScissorTest(ne=x)},this.setOpaqueSort=function(x){Nt=x},this.setTransparentSort=function(x){ue=x},this.getClearColor=function(x){return x.copy(T.getClearColor())},this.setClearColor=function(){T.setClearColor(...arguments)},this.getClearAlpha=function(){return T.getClearAlpha()},this.setClearAlpha=function(){T.setClearAlpha(...arguments)},this.clear=function(x=!0,C=!0,B=!0){let N=0;if(x){let O=!1;if(et!==null){const ht=et.texture.format;O=m.has(ht)}if(O){const ht=et.texture.type,vt=p.has(ht),lt=T.getClearColor(),_t=T.getClearAlpha(),yt=lt.r,Dt=lt.g,Gt=lt.b;vt?(M[0]=yt,M[1]=Dt,M[2]=Gt,M[3]=_t,I.clearBufferuiv(I.COLOR,0,M)):(A[0]=yt,A[1]=Dt,A[2]=Gt,A[3]=_t,I.clearBufferiv(I.COLOR,0,A))}else N|=I.COLOR_BUFFER_BIT}C&&(N|=I.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),B&&(N|=I.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),N!==0&&I.clear(N)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(x){x.setRenderer(this),z=x},this.dispose=function(){e.removeEventListener("webglcontextlost",bt,!1),e.removeEventListener("webglcontextrestored",Ft,!1),e.removeEventListener("webglcontextcreationerror",ft,!1),T.dispose(),ct.dispose(),X.dispose(),Pt.dispose(),At.dispose(),w.dispose(),tt.dispose(),F.dispose(),rt.dispose(),Et.dispose(),J.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",Wl),nt.removeEventListener("sessionend",Xl),oi.stop()};function bt(x){x.preventDefault(),fc("WebGLRenderer: Context Lost."),D=!0}function Ft(){fc("WebGLRenderer: Context Restored."),D=!1;const x=_e.autoReset,C=ot.enabled,B=ot.autoUpdate,N=ot.needsUpdate,O=ot.type;Ot(),_e.autoReset=x,ot.enabled=C,ot.autoUpdate=B,ot.needsUpdate=N,ot.type=O}function ft(x){Kt("WebGLRenderer: A WebGL context could not be created. Reason: ",x.statusMessage)}function jt(x){const C=x.target;C.removeEventListener("dispose",jt),Me(C)}function Me(x){Gn(x),At.remove(x)}function Gn(x){const C=At.get(x).programs;C!==void 0&&(C.forEach(function(B){J.releaseProgram(B)}),x.isShaderMaterial&&J.releaseShaderCache(x))}this.renderBufferDirect=function(x,C,B,N,O,ht){C===null&&(C=Ve);const vt=O.isMesh&&O.matrixWorld.determinantAffine()<0,lt=zd(x,C,B,N,O);ut.setMaterial(N,vt);let _t=B.index,yt=1;if(N.wireframe===!0){if(_t=F.getWireframeAttribute(B),_t===void 0)return;yt=2}const Dt=B.drawRange,Gt=B.attributes.position;let St=Dt.start*yt,Vt=(Dt.start+Dt.count)*yt;ht!==null&&(St=Math.max(St,ht.start*yt),Vt=Math.min(Vt,(ht.start+ht.count)*yt)),_t!==null?(St=Math.max(St,0),Vt=Math.min(Vt,_t.count)):Gt!=null&&(St=Math.max(St,0),Vt=Math.min(Vt,Gt.count));const de=Vt-St;if(de<0||de===1/0)return;rt.setup(O,N,lt,B,_t);let se,ie=G;if(_t!==null&&(se=_.get(_t),ie=at,ie.setIndex(se)),O.isMesh)N.wireframe===!0?(ut.setLineWidth(N.wireframeLinewidth*Xe()),ie.setMode(I.LINES)):ie.setMode(I.TRIANGLES);else if(O.isLine){let Re=N.linewidth;Re===void 0&&(Re=1),ut.setLineWidth(Re*Xe()),O.isLineSegments?ie.setMode(I.LINES):O.isLineLoop?ie.setMode(I.LINE_LOOP):ie.setMode(I.LINE_STRIP)}else O.isPoints?ie.setMode(I.POINTS):O.isSprite&&ie.setMode(I.TRIANGLES);if(O.isBatchedMesh)if(re.get("WEBGL_multi_draw"))ie.renderMultiDraw(O._multiDrawStarts,O._multiDrawCounts,O._multiDrawCount);else{const Re=O._multiDrawStarts,Mt=O._multiDrawCounts,De=O._multiDrawCount,Yt=_t?_.get(_t).bytesPerElement:1,ai=At.get(N).currentProgram.getUniforms();for(let Ce=0;Ce<De;Ce++)ai.setValue(I,"_gl_DrawID",Ce),ie.render(Re[Ce]/Yt,Mt[Ce])}else if(O.isInstancedMesh)ie.renderInstances(St,de,O.count);else if(B.isInstancedBufferGeometry){const Re=B._maxInstanceCount!==void 0?B._maxInstanceCount:1/0,Mt=Math.min(B.instanceCount,Re);ie.renderInstances(St,de,Mt)}else ie.render(St,de)};function Vl(x,C,B,N){z!==null&&x.isNodeMaterial&&z.setObject(N,x),ge===!0&&$.setState(x,B,!1),x.transparent===!0&&x.side===xn&&x.forceSinglePass===!1?(x.side=ke,x.needsUpdate=!0,ji(x,C,N),x.side=ei,x.needsUpdate=!0,ji(x,C,N),x.side=xn):ji(x,C,N)}this.compile=function(x,C,B=null){B===null&&(B=x),z!==null&&z.renderStart(x,C,B),b=X.get(B),b.init(C),y.push(b),B.traverseVisible(function(O){O.isLight&&O.layers.test(C.layers)&&(b.pushLight(O),O.castShadow&&b.pushShadow(O))}),x!==B&&x.traverseVisible(function(O){O.isLight&&O.layers.test(C.layers)&&(b.pushLight(O),O.castShadow&&b.pushShadow(O))}),b.setupLights(),z!==null&&z.updateLights(b.state.lightsArray),Oe=this.localClippingEnabled,ge=$.init(this.clippingPlanes,Oe),ge===!0&&$.setGlobalState(this.clippingPlanes,C),z!==null&&ot.render(b.state.shadowsArray,B,C);const N=new Set;return x.traverse(function(O){if(!(O.isMesh||O.isPoints||O.isLine||O.isSprite))return;const ht=O.material;if(ht)if(Array.isArray(ht))for(let vt=0;vt<ht.length;vt++){const lt=ht[vt];Vl(lt,B,C,O),N.add(lt)}else Vl(ht,B,C,O),N.add(ht)}),b=y.pop(),z!==null&&z.renderEnd(),N},this.compileAsync=function(x,C,B=null){const N=this.compile(x,C,B);return new Promise(O=>{function ht(){if(N.forEach(function(vt){const _t=At.get(vt).currentProgram;(_t===void 0||_t.isReady())&&N.delete(vt)}),N.size===0){O(x);return}setTimeout(ht,10)}re.get("KHR_parallel_shader_compile")!==null?ht():setTimeout(ht,10)})};let eo=null;function kd(x){eo&&eo(x)}function Wl(){oi.stop()}function Xl(){oi.start()}const oi=new Wu;oi.setAnimationLoop(kd),typeof self<"u"&&oi.setContext(self),this.setAnimationLoop=function(x){eo=x,nt.setAnimationLoop(x),x===null?oi.stop():oi.start()},nt.addEventListener("sessionstart",Wl),nt.addEventListener("sessionend",Xl),this.render=function(x,C){if(C!==void 0&&C.isCamera!==!0){Kt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;z!==null&&z.renderStart(x,C);const B=nt.enabled===!0&&nt.isPresenting===!0,N=k!==null&&(et===null||B)&&k.begin(L,et);if(x.matrixWorldAutoUpdate===!0&&x.updateMatrixWorld(),C.parent===null&&C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(C),C=nt.getCamera()),x.isScene===!0&&x.onBeforeRender(L,x,C,et),b=X.get(x,y.length),b.init(C),b.state.textureUnits=Pt.getTextureUnits(),y.push(b),ae.multiplyMatrices(C.projectionMatrix,C.matrixWorldInverse),C.isArrayCamera?be.setFromArrayCamera(C):Ht.setFromProjectionMatrix(ae,cn,C.reversedDepth),Oe=this.localClippingEnabled,ge=$.init(this.clippingPlanes,Oe),R=ct.get(x,g.length),R.init(),g.push(R),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){const vt=L.xr.getDepthSensingMesh();vt!==null&&no(vt,C,-1/0,L.sortObjects)}no(x,C,0,L.sortObjects),R.finish(),z!==null&&z.updateLights(b.state.lightsArray),L.sortObjects===!0&&R.sort(Nt,ue),We=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,We&&T.addToRenderList(R,x),this.info.autoReset===!0&&this.info.reset(),ge===!0&&$.beginShadows();const O=b.state.shadowsArray;if(ot.render(O,x,C),ge===!0&&$.endShadows(),(N&&k.hasRenderPass())===!1){const vt=R.opaque,lt=R.transmissive;if(b.setupLights(),C.isArrayCamera){const _t=C.cameras;if(lt.length>0)for(let yt=0,Dt=_t.length;yt<Dt;yt++){const Gt=_t[yt];$l(vt,lt,x,Gt)}We&&T.render(x);for(let yt=0,Dt=_t.length;yt<Dt;yt++){const Gt=_t[yt];ql(R,x,Gt,Gt.viewport)}}else lt.length>0&&$l(vt,lt,x,C),We&&T.render(x),ql(R,x,C)}et!==null&&H===0&&(Pt.updateMultisampleRenderTarget(et),Pt.updateRenderTargetMipmap(et)),N&&k.end(L),x.isScene===!0&&x.onAfterRender(L,x,C),rt.resetDefaultState(),V=-1,Q=null,y.pop(),y.length>0?(b=y[y.length-1],Pt.setTextureUnits(b.state.textureUnits),ge===!0&&$.setGlobalState(L.clippingPlanes,b.state.camera)):b=null,g.pop(),g.length>0?R=g[g.length-1]:R=null,z!==null&&z.renderEnd()};function no(x,C,B,N){if(x.visible===!1)return;if(x.layers.test(C.layers)){if(x.isGroup)B=x.renderOrder;else if(x.isLOD)x.autoUpdate===!0&&x.update(C);else if(x.isLight)b.pushLight(x),x.castShadow&&b.pushShadow(x);else if(x.isSprite){const vt=C.isArrayCamera?be:Ht;if(!x.frustumCulled||x.intersectsFrustum(vt)){N&&Se.setFromMatrixPosition(x.matrixWorld).applyMatrix4(ae);const lt=tt.update(x),_t=x.material;_t.visible&&R.push(x,lt,_t,B,Se.z,null,C)}}else if(x.isMesh||x.isLine||x.isPoints){const vt=C.isArrayCamera?be:Ht;if(!x.frustumCulled||x.intersectsFrustum(vt)){const lt=tt.update(x),_t=x.material;if(N&&(x.boundingSphere!==void 0?(x.boundingSphere===null&&x.computeBoundingSphere(),Se.copy(x.boundingSphere.center)):(lt.boundingSphere===null&&lt.computeBoundingSphere(),Se.copy(lt.boundingSphere.center)),Se.applyMatrix4(x.matrixWorld).applyMatrix4(ae)),Array.isArray(_t)){const yt=lt.groups;for(let Dt=0,Gt=yt.length;Dt<Gt;Dt++){const St=yt[Dt],Vt=_t[St.materialIndex];Vt&&Vt.visible&&R.push(x,lt,Vt,B,Se.z,St,C)}}else _t.visible&&R.push(x,lt,_t,B,Se.z,null,C)}}}const ht=x.children;for(let vt=0,lt=ht.length;vt<lt;vt++)no(ht[vt],C,B,N)}function ql(x,C,B,N){const{opaque:O,transmissive:ht,transparent:vt}=x;b.setupLightsView(B),ge===!0&&$.setGlobalState(L.clippingPlanes,B),N&&ut.viewport(j.copy(N)),O.length>0&&Ds(O,C,B),ht.length>0&&Ds(ht,C,B),vt.length>0&&Ds(vt,C,B),ut.buffers.depth.setTest(!0),ut.buffers.depth.setMask(!0),ut.buffers.color.setMask(!0),ut.setPolygonOffset(!1)}function $l(x,C,B,N){if((B.isScene===!0?B.overrideMaterial:null)!==null)return;if(b.state.transmissionRenderTarget[N.id]===void 0){const St=re.has("EXT_color_buffer_half_float")||re.has("EXT_color_buffer_float");b.state.transmissionRenderTarget[N.id]=new un(1,1,{generateMipmaps:!0,type:St?dn:Ze,minFilter:Qn,samples:Math.max(4,oe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Xt.workingColorSpace})}const ht=b.state.transmissionRenderTarget[N.id],vt=N.viewport||j;ht.setSize(vt.z*L.transmissionResolutionScale,vt.w*L.transmissionResolutionScale);const lt=L.getRenderTarget(),_t=L.getActiveCubeFace(),yt=L.getActiveMipmapLevel();L.setRenderTarget(ht),L.getClearColor(Y),mt=L.getClearAlpha(),mt<1&&L.setClearColor(16777215,.5),L.clear(),We&&T.render(B);const Dt=L.toneMapping;L.toneMapping=Bn;const Gt=N.viewport;if(N.viewport!==void 0&&(N.viewport=void 0),b.setupLightsView(N),ge===!0&&$.setGlobalState(L.clippingPlanes,N),Ds(x,B,N),Pt.updateMultisampleRenderTarget(ht),Pt.updateRenderTargetMipmap(ht),re.has("WEBGL_multisampled_render_to_texture")===!1){let St=!1;for(let Vt=0,de=C.length;Vt<de;Vt++){const se=C[Vt],{object:ie,geometry:Re,material:Mt,group:De}=se;if(Mt.side===xn&&ie.layers.test(N.layers)){const Yt=Mt.side;Mt.side=ke,Mt.needsUpdate=!0,Yl(ie,B,N,Re,Mt,De),Mt.side=Yt,Mt.needsUpdate=!0,St=!0}}St===!0&&(Pt.updateMultisampleRenderTarget(ht),Pt.updateRenderTargetMipmap(ht))}L.setRenderTarget(lt,_t,yt),L.setClearColor(Y,mt),Gt!==void 0&&(N.viewport=Gt),L.toneMapping=Dt}function Ds(x,C,B){const N=C.isScene===!0?C.overrideMaterial:null;for(let O=0,ht=x.length;O<ht;O++){const vt=x[O],{object:lt,geometry:_t,group:yt}=vt;let Dt=vt.material;Dt.allowOverride===!0&&N!==null&&(Dt=N),lt.layers.test(B.layers)&&Yl(lt,C,B,_t,Dt,yt)}}function Yl(x,C,B,N,O,ht){z!==null&&O.isNodeMaterial&&z.setObject(x,O),x.onBeforeRender(L,C,B,N,O,ht),x.modelViewMatrix.multiplyMatrices(B.matrixWorldInverse,x.matrixWorld),x.normalMatrix.getNormalMatrix(x.modelViewMatrix),O.onBeforeRender(L,C,B,N,x,ht),O.transparent===!0&&O.side===xn&&O.forceSinglePass===!1?(O.side=ke,O.needsUpdate=!0,L.renderBufferDirect(B,C,N,O,x,ht),O.side=ei,O.needsUpdate=!0,L.renderBufferDirect(B,C,N,O,x,ht),O.side=xn):L.renderBufferDirect(B,C,N,O,x,ht),x.onAfterRender(L,C,B,N,O,ht)}function Kl(x){let C=0;for(const B of x)B.texture!==null&&C++;return C}function ji(x,C,B){C.isScene!==!0&&(C=Ve);const N=At.get(x),O=b.state.lights,ht=b.state.shadowsArray,vt=O.state.version,lt=J.getParameters(x,O.state,ht,C,B,b.state.lightProbeGridArray),_t=J.getProgramCacheKey(lt);let yt=N.programs;N.environment=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?C.environment:null,N.fog=C.fog;const Dt=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap;N.envMap=w.get(x.envMap||N.environment,Dt),N.envMapRotation=N.environment!==null&&x.envMap===null?C.environmentRotation:x.envMapRotation,yt===void 0&&(x.addEventListener("dispose",jt),yt=new Map,N.programs=yt,N.programVariants=new Map);let Gt=yt.get(_t);if(Gt!==void 0){if(N.currentProgram===Gt&&N.lightsStateVersion===vt)return Jl(x,lt),Gt}else lt.uniforms=J.getUniforms(x),z!==null&&x.isNodeMaterial&&z.build(x,B,lt),x.onBeforeCompile(lt,L),Gt=J.acquireProgram(lt,_t),yt.set(_t,Gt),N.uniforms=lt.uniforms;const St=N.uniforms;return(!x.isShaderMaterial&&!x.isRawShaderMaterial||x.clipping===!0)&&(St.clippingPlanes=$.uniform),Jl(x,lt),N.needsLights=Gd(x),N.lightsStateVersion=vt,N.needsLights&&(St.ambientLightColor.value=O.state.ambient,St.lightProbe.value=O.state.probe,St.sunLights.value=O.state.sun,St.sunLightShadows.value=O.state.sunShadow,St.directionalLights.value=O.state.directional,St.directionalLightShadows.value=O.state.directionalShadow,St.spotLights.value=O.state.spot,St.spotLightShadows.value=O.state.spotShadow,St.rectAreaLights.value=O.state.rectArea,St.ltc_1.value=O.state.rectAreaLTC1,St.ltc_2.value=O.state.rectAreaLTC2,St.pointLights.value=O.state.point,St.pointLightShadows.value=O.state.pointShadow,St.hemisphereLights.value=O.state.hemi,St.sunShadowMatrix.value=O.state.sunShadowMatrix,St.sunShadowCascade.value=O.state.sunShadowCascade,St.directionalShadowMatrix.value=O.state.directionalShadowMatrix,St.spotLightMatrix.value=O.state.spotLightMatrix,St.spotLightMap.value=O.state.spotLightMap,St.pointShadowMatrix.value=O.state.pointShadowMatrix),N.numLightProbeGrids=Kl(b.state.lightProbeGridArray),N.currentProgram=Gt,N.uniformsList=null,Gt}function Bd(x,C,B,N,O){const ht=At.get(x),vt=ht.currentProgram.id+","+N+","+O;let lt=ht.programVariants.get(vt);return lt===void 0?(lt=ji(x,C,B),ht.programVariants.set(vt,lt)):(ht.currentProgram=lt,ht.uniformsList=null,ht.outputColorSpace=N,ht.toneMapping=O),lt}function Zl(x){if(x.uniformsList===null){const C=x.currentProgram.getUniforms();x.uniformsList=yr.seqWithValue(C.seq,x.uniforms)}return x.uniformsList}function Jl(x,C){const B=At.get(x);B.outputColorSpace=C.outputColorSpace,B.batching=C.batching,B.batchingColor=C.batchingColor,B.instancing=C.instancing,B.instancingColor=C.instancingColor,B.instancingMorph=C.instancingMorph,B.skinning=C.skinning,B.morphTargets=C.morphTargets,B.morphNormals=C.morphNormals,B.morphColors=C.morphColors,B.morphTargetsCount=C.morphTargetsCount,B.numClippingPlanes=C.numClippingPlanes,B.numIntersection=C.numClipIntersection,B.vertexAlphas=C.vertexAlphas,B.vertexTangents=C.vertexTangents,B.toneMapping=C.toneMapping}function zd(x,C,B,N,O){C.isScene!==!0&&(C=Ve),Pt.resetTextureUnits();const ht=C.fog,vt=N.isMeshStandardMaterial||N.isMeshLambertMaterial||N.isMeshPhongMaterial?C.environment:null,lt=et===null?L.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:Xt.workingColorSpace,_t=N.isMeshStandardMaterial||N.isMeshLambertMaterial&&!N.envMap||N.isMeshPhongMaterial&&!N.envMap,yt=w.get(N.envMap||vt,_t),Dt=N.vertexColors===!0&&!!B.attributes.color&&B.attributes.color.itemSize===4,Gt=!!B.attributes.tangent&&(!!N.normalMap||N.anisotropy>0),St=!!B.morphAttributes.position,Vt=!!B.morphAttributes.normal,de=!!B.morphAttributes.color;let se=Bn;N.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(se=L.toneMapping);const ie=B.morphAttributes.position||B.morphAttributes.normal||B.morphAttributes.color,Re=ie!==void 0?ie.length:0,Mt=At.get(N),De=b.state.lights;if(ge===!0&&(Oe===!0||x!==Q)){const le=x===Q&&N.id===V;$.setState(N,x,le)}let Yt=!1,ai=!1;N.version===Mt.__version?Mt.needsLights&&Mt.lightsStateVersion!==De.state.version||O.isBatchedMesh&&Mt.batching===!1||!O.isBatchedMesh&&Mt.batching===!0||O.isBatchedMesh&&Mt.batchingColor===!0&&O._colorsTexture===null||O.isBatchedMesh&&Mt.batchingColor===!1&&O._colorsTexture!==null||O.isInstancedMesh&&Mt.instancing===!1||!O.isInstancedMesh&&Mt.instancing===!0||O.isSkinnedMesh&&Mt.skinning===!1||!O.isSkinnedMesh&&Mt.skinning===!0||O.isInstancedMesh&&Mt.instancingColor===!0&&O.instanceColor===null||O.isInstancedMesh&&Mt.instancingColor===!1&&O.instanceColor!==null||O.isInstancedMesh&&Mt.instancingMorph===!0&&O.morphTexture===null||O.isInstancedMesh&&Mt.instancingMorph===!1&&O.morphTexture!==null||Mt.envMap!==yt||N.fog===!0&&Mt.fog!==ht||Mt.numClippingPlanes!==void 0&&(Mt.numClippingPlanes!==$.numPlanes||Mt.numIntersection!==$.numIntersection)||Mt.vertexAlphas!==Dt||Mt.vertexTangents!==Gt||Mt.morphTargets!==St||Mt.morphNormals!==Vt||Mt.morphColors!==de||Mt.morphTargetsCount!==Re||Mt.numLightProbeGrids!==Kl(b.state.lightProbeGridArray)?Yt=!0:(Mt.outputColorSpace!==lt||Mt.toneMapping!==se)&&(ai=!0):(Yt=!0,Mt.__version=N.version);let Ce=Mt.currentProgram;(Yt===!0||ai===!0)&&(Ce=ai===!0?Bd(N,C,O,lt,se):ji(N,C,O),z&&N.isNodeMaterial&&z.onUpdateProgram(N,Ce,Mt));let Ns=!1,Vn=!1,li=!1;const qt=Ce.getUniforms(),Te=Mt.uniforms;if(ut.useProgram(Ce.program)&&(Ns=!0,Vn=!0,li=!0),N.id!==V&&(V=N.id,Vn=!0),Ns||Q!==x){ut.buffers.depth.getReversed()&&x.reversedDepth!==!0&&(x._reversedDepth=!0,x.updateProjectionMatrix()),qt.setValue(I,"projectionMatrix",x.projectionMatrix),qt.setValue(I,"viewMatrix",x.matrixWorldInverse);const we=qt.map.cameraPosition;we!==void 0&&we.setValue(I,fn.setFromMatrixPosition(x.matrixWorld)),oe.logarithmicDepthBuffer&&qt.setValue(I,"logDepthBufFC",2/(Math.log(x.far+1)/Math.LN2)),(N.isMeshPhongMaterial||N.isMeshToonMaterial||N.isMeshLambertMaterial||N.isMeshBasicMaterial||N.isMeshStandardMaterial||N.isShaderMaterial)&&qt.setValue(I,"isOrthographic",x.isOrthographicCamera===!0),Q!==x&&(Q=x,Vn=!0,li=!0)}if(Mt.needsLights&&(De.state.sunShadowMap.length>0&&qt.setValue(I,"sunShadowMap",De.state.sunShadowMap,Pt),De.state.directionalShadowMap.length>0&&qt.setValue(I,"directionalShadowMap",De.state.directionalShadowMap,Pt),De.state.spotShadowMap.length>0&&qt.setValue(I,"spotShadowMap",De.state.spotShadowMap,Pt),De.state.pointShadowMap.length>0&&qt.setValue(I,"pointShadowMap",De.state.pointShadowMap,Pt)),O.isSkinnedMesh){qt.setOptional(I,O,"bindMatrix"),qt.setOptional(I,O,"bindMatrixInverse");const le=O.skeleton;le&&(le.boneTexture===null&&le.computeBoneTexture(),qt.setValue(I,"boneTexture",le.boneTexture,Pt))}O.isBatchedMesh&&(qt.setOptional(I,O,"batchingTexture"),qt.setValue(I,"batchingTexture",O._matricesTexture,Pt),qt.setOptional(I,O,"batchingIdTexture"),qt.setValue(I,"batchingIdTexture",O._indirectTexture,Pt),qt.setOptional(I,O,"batchingColorTexture"),O._colorsTexture!==null&&qt.setValue(I,"batchingColorTexture",O._colorsTexture,Pt));const en=B.morphAttributes;if((en.position!==void 0||en.normal!==void 0||en.color!==void 0)&&K.update(O,B,Ce),(Vn||Mt.receiveShadow!==O.receiveShadow)&&(Mt.receiveShadow=O.receiveShadow,qt.setValue(I,"receiveShadow",O.receiveShadow)),(N.isMeshStandardMaterial||N.isMeshLambertMaterial||N.isMeshPhongMaterial)&&N.envMap===null&&C.environment!==null&&(Te.envMapIntensity.value=C.environmentIntensity),Te.dfgLUT!==void 0&&(Te.dfgLUT.value=bv()),Vn){if(qt.setValue(I,"toneMappingExposure",L.toneMappingExposure),Mt.needsLights&&Hd(Te,li),ht&&N.fog===!0&&st.refreshFogUniforms(Te,ht),st.refreshMaterialUniforms(Te,N,gt,Tt,b.state.transmissionRenderTarget[x.id]),Mt.needsLights&&Mt.numLightProbeGrids>0){const le=E;let we=0;for(const Tn of b.state.lightProbeGridArray)Tn.texture!==null&&(le.textures[we]=Tn.texture,le.min[we]=Tn.boundingBox.min,le.max[we]=Tn.boundingBox.max,le.resolution[we]=Tn.resolution,we++);for(const Tn in le)le[Tn].length=we;Te.probesSH.value=le.textures,Te.probesMin.value=le.min,Te.probesMax.value=le.max,Te.probesResolution.value=le.resolution}yr.upload(I,Zl(Mt),Te,Pt)}if(N.isShaderMaterial&&N.uniformsNeedUpdate===!0&&(yr.upload(I,Zl(Mt),Te,Pt),N.uniformsNeedUpdate=!1),N.isSpriteMaterial&&qt.setValue(I,"center",O.center),qt.setValue(I,"modelViewMatrix",O.modelViewMatrix),qt.setValue(I,"normalMatrix",O.normalMatrix),qt.setValue(I,"modelMatrix",O.matrixWorld),N.uniformsGroups!==void 0){const le=N.uniformsGroups;for(let we=0,Tn=le.length;we<Tn;we++){const jl=le[we];Et.update(jl,Ce),Et.bind(jl,Ce)}}return Ce}function Hd(x,C){x.ambientLightColor.needsUpdate=C,x.lightProbe.needsUpdate=C,x.sunLights.needsUpdate=C,x.sunLightShadows.needsUpdate=C,x.directionalLights.needsUpdate=C,x.directionalLightShadows.needsUpdate=C,x.pointLights.needsUpdate=C,x.pointLightShadows.needsUpdate=C,x.spotLights.needsUpdate=C,x.spotLightShadows.needsUpdate=C,x.rectAreaLights.needsUpdate=C,x.hemisphereLights.needsUpdate=C}function Gd(x){return x.isMeshLambertMaterial||x.isMeshToonMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isShadowMaterial||x.isShaderMaterial&&x.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(x,C,B){const N=At.get(x);N.__autoAllocateDepthBuffer=x.resolveDepthBuffer===!1,N.__autoAllocateDepthBuffer===!1&&(N.__useRenderToTexture=!1),At.get(x.texture).__webglTexture=C,At.get(x.depthTexture).__webglTexture=N.__autoAllocateDepthBuffer?void 0:B,N.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(x,C){const B=At.get(x);B.__webglFramebuffer=C,B.__useDefaultFramebuffer=C===void 0},this.setRenderTarget=function(x,C=0,B=0){et=x,Z=C,H=B;let N=null,O=!1,ht=!1;if(x){const lt=At.get(x);if(lt.__useDefaultFramebuffer!==void 0){ut.bindFramebuffer(I.FRAMEBUFFER,lt.__webglFramebuffer),j.copy(x.viewport),wt.copy(x.scissor),It=x.scissorTest,ut.viewport(j),ut.scissor(wt),ut.setScissorTest(It),V=-1;return}else if(lt.__webglFramebuffer===void 0)Pt.setupRenderTarget(x);else if(lt.__hasExternalTextures)Pt.rebindTextures(x,At.get(x.texture).__webglTexture,At.get(x.depthTexture).__webglTexture);else if(x.depthBuffer){const Dt=x.depthTexture;if(lt.__boundDepthTexture!==Dt){if(Dt!==null&&At.has(Dt)&&(x.width!==Dt.image.width||x.height!==Dt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Pt.setupDepthRenderbuffer(x)}}const _t=x.texture;(_t.isData3DTexture||_t.isDataArrayTexture||_t.isCompressedArrayTexture)&&(ht=!0);const yt=At.get(x).__webglFramebuffer;x.isWebGLCubeRenderTarget?(Array.isArray(yt[C])?N=yt[C][B]:N=yt[C],O=!0):x.samples>0&&Pt.useMultisampledRTT(x)===!1?N=At.get(x).__webglMultisampledFramebuffer:Array.isArray(yt)?N=yt[B]:N=yt,j.copy(x.viewport),wt.copy(x.scissor),It=x.scissorTest}else j.copy(Rt).multiplyScalar(gt).floor(),wt.copy(Qt).multiplyScalar(gt).floor(),It=ne;if(B!==0&&(N=q),ut.bindFramebuffer(I.FRAMEBUFFER,N)&&ut.drawBuffers(x,N),ut.viewport(j),ut.scissor(wt),ut.setScissorTest(It),O){const lt=At.get(x.texture);I.framebufferTexture2D(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_CUBE_MAP_POSITIVE_X+C,lt.__webglTexture,B)}else if(ht){const lt=C;for(let _t=0;_t<x.textures.length;_t++){const yt=At.get(x.textures[_t]);I.framebufferTextureLayer(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0+_t,yt.__webglTexture,B,lt)}}else if(x!==null&&B!==0){const lt=At.get(x.texture);I.framebufferTexture2D(I.FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,lt.__webglTexture,B)}V=-1};function Ql(x){const C=At.get(x);return(C.__readFormat!==x.format||C.__readType!==x.type)&&(C.__readFormat=x.format,C.__readType=x.type,C.__formatReadable=oe.textureFormatReadable(x.format),C.__typeReadable=oe.textureTypeReadable(x.type)),C}this.readRenderTargetPixels=function(x,C,B,N,O,ht,vt,lt=0){if(!(x&&x.isWebGLRenderTarget)){Kt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _t=At.get(x).__webglFramebuffer;if(x.isWebGLCubeRenderTarget&&vt!==void 0&&(_t=_t[vt],Array.isArray(_t)&&(_t=_t[0])),_t){ut.bindFramebuffer(I.FRAMEBUFFER,_t);try{const yt=x.textures[lt],Dt=yt.format,Gt=yt.type;x.textures.length>1&&I.readBuffer(I.COLOR_ATTACHMENT0+lt);const St=Ql(yt);if(St.__formatReadable===!1){Kt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(St.__typeReadable===!1){Kt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}C>=0&&C<=x.width-N&&B>=0&&B<=x.height-O&&I.readPixels(C,B,N,O,it.convert(Dt),it.convert(Gt),ht)}finally{const yt=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(I.FRAMEBUFFER,yt)}}},this.readRenderTargetPixelsAsync=async function(x,C,B,N,O,ht,vt,lt=0){if(!(x&&x.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _t=At.get(x).__webglFramebuffer;if(x.isWebGLCubeRenderTarget&&vt!==void 0&&(_t=_t[vt],Array.isArray(_t)&&(_t=_t[0])),_t)if(C>=0&&C<=x.width-N&&B>=0&&B<=x.height-O){ut.bindFramebuffer(I.FRAMEBUFFER,_t);const yt=x.textures[lt],Dt=yt.format,Gt=yt.type;x.textures.length>1&&I.readBuffer(I.COLOR_ATTACHMENT0+lt);const St=Ql(yt);if(St.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(St.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const Vt=I.createBuffer();I.bindBuffer(I.PIXEL_PACK_BUFFER,Vt),I.bufferData(I.PIXEL_PACK_BUFFER,ht.byteLength,I.STREAM_READ),I.readPixels(C,B,N,O,it.convert(Dt),it.convert(Gt),0),I.bindBuffer(I.PIXEL_PACK_BUFFER,null);const de=et!==null?At.get(et).__webglFramebuffer:null;ut.bindFramebuffer(I.FRAMEBUFFER,de);const se=I.fenceSync(I.SYNC_GPU_COMMANDS_COMPLETE,0);return I.flush(),await $f(I,se,4),I.bindBuffer(I.PIXEL_PACK_BUFFER,Vt),I.getBufferSubData(I.PIXEL_PACK_BUFFER,0,ht),I.bindBuffer(I.PIXEL_PACK_BUFFER,null),I.deleteBuffer(Vt),I.deleteSync(se),ht}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(x,C=null,B=0){const N=Math.pow(2,-B),O=Math.floor(x.image.width*N),ht=Math.floor(x.image.height*N),vt=C!==null?C.x:0,lt=C!==null?C.y:0;Pt.setTexture2D(x,0),I.copyTexSubImage2D(I.TEXTURE_2D,B,0,0,vt,lt,O,ht),ut.unbindTexture()},this.copyTextureToTexture=function(x,C,B=null,N=null,O=0,ht=0){let vt,lt,_t,yt,Dt,Gt,St,Vt,de;const se=x.isCompressedTexture?x.mipmaps[ht]:x.image;if(B!==null)vt=B.max.x-B.min.x,lt=B.max.y-B.min.y,_t=B.isBox3?B.max.z-B.min.z:1,yt=B.min.x,Dt=B.min.y,Gt=B.isBox3?B.min.z:0;else{const qt=Math.pow(2,-O);vt=Math.floor(se.width*qt),lt=Math.floor(se.height*qt),x.isDataArrayTexture?_t=se.depth:x.isData3DTexture?_t=Math.floor(se.depth*qt):_t=1,yt=0,Dt=0,Gt=0}N!==null?(St=N.x,Vt=N.y,de=N.z):(St=0,Vt=0,de=0);const ie=it.convert(C.format),Re=it.convert(C.type);let Mt;C.isData3DTexture?(Pt.setTexture3D(C,0),Mt=I.TEXTURE_3D):C.isDataArrayTexture||C.isCompressedArrayTexture?(Pt.setTexture2DArray(C,0),Mt=I.TEXTURE_2D_ARRAY):(Pt.setTexture2D(C,0),Mt=I.TEXTURE_2D),ut.activeTexture(I.TEXTURE0),ut.pixelStorei(I.UNPACK_FLIP_Y_WEBGL,C.flipY),ut.pixelStorei(I.UNPACK_PREMULTIPLY_ALPHA_WEBGL,C.premultiplyAlpha),ut.pixelStorei(I.UNPACK_ALIGNMENT,C.unpackAlignment);const De=ut.getParameter(I.UNPACK_ROW_LENGTH),Yt=ut.getParameter(I.UNPACK_IMAGE_HEIGHT),ai=ut.getParameter(I.UNPACK_SKIP_PIXELS),Ce=ut.getParameter(I.UNPACK_SKIP_ROWS),Ns=ut.getParameter(I.UNPACK_SKIP_IMAGES);ut.pixelStorei(I.UNPACK_ROW_LENGTH,se.width),ut.pixelStorei(I.UNPACK_IMAGE_HEIGHT,se.height),ut.pixelStorei(I.UNPACK_SKIP_PIXELS,yt),ut.pixelStorei(I.UNPACK_SKIP_ROWS,Dt),ut.pixelStorei(I.UNPACK_SKIP_IMAGES,Gt);const Vn=x.isDataArrayTexture||x.isData3DTexture,li=C.isDataArrayTexture||C.isData3DTexture;if(x.isDepthTexture){const qt=At.get(x),Te=At.get(C),en=At.get(qt.__renderTarget),le=At.get(Te.__renderTarget);ut.bindFramebuffer(I.READ_FRAMEBUFFER,en.__webglFramebuffer),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,le.__webglFramebuffer);for(let we=0;we<_t;we++)Vn&&(I.framebufferTextureLayer(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,At.get(x).__webglTexture,O,Gt+we),I.framebufferTextureLayer(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,At.get(C).__webglTexture,ht,de+we)),I.blitFramebuffer(yt,Dt,yt+vt,Dt+lt,St,Vt,St+vt,Vt+lt,I.DEPTH_BUFFER_BIT,I.NEAREST);ut.bindFramebuffer(I.READ_FRAMEBUFFER,null),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,null)}else if(O!==0||x.isRenderTargetTexture||At.has(x)){const qt=At.get(x),Te=At.get(C);ut.bindFramebuffer(I.READ_FRAMEBUFFER,P),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,W);for(let en=0;en<_t;en++)Vn?I.framebufferTextureLayer(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,qt.__webglTexture,O,Gt+en):I.framebufferTexture2D(I.READ_FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,qt.__webglTexture,O),li?I.framebufferTextureLayer(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,Te.__webglTexture,ht,de+en):I.framebufferTexture2D(I.DRAW_FRAMEBUFFER,I.COLOR_ATTACHMENT0,I.TEXTURE_2D,Te.__webglTexture,ht),O!==0?I.blitFramebuffer(yt,Dt,yt+vt,Dt+lt,St,Vt,St+vt,Vt+lt,I.COLOR_BUFFER_BIT,I.NEAREST):li?I.copyTexSubImage3D(Mt,ht,St,Vt,de+en,yt,Dt,vt,lt):I.copyTexSubImage2D(Mt,ht,St,Vt,yt,Dt,vt,lt);ut.bindFramebuffer(I.READ_FRAMEBUFFER,null),ut.bindFramebuffer(I.DRAW_FRAMEBUFFER,null)}else li?x.isDataTexture||x.isData3DTexture?I.texSubImage3D(Mt,ht,St,Vt,de,vt,lt,_t,ie,Re,se.data):C.isCompressedArrayTexture?I.compressedTexSubImage3D(Mt,ht,St,Vt,de,vt,lt,_t,ie,se.data):I.texSubImage3D(Mt,ht,St,Vt,de,vt,lt,_t,ie,Re,se):x.isDataTexture?I.texSubImage2D(I.TEXTURE_2D,ht,St,Vt,vt,lt,ie,Re,se.data):x.isCompressedTexture?I.compressedTexSubImage2D(I.TEXTURE_2D,ht,St,Vt,se.width,se.height,ie,se.data):I.texSubImage2D(I.TEXTURE_2D,ht,St,Vt,vt,lt,ie,Re,se);ut.pixelStorei(I.UNPACK_ROW_LENGTH,De),ut.pixelStorei(I.UNPACK_IMAGE_HEIGHT,Yt),ut.pixelStorei(I.UNPACK_SKIP_PIXELS,ai),ut.pixelStorei(I.UNPACK_SKIP_ROWS,Ce),ut.pixelStorei(I.UNPACK_SKIP_IMAGES,Ns),ht===0&&C.generateMipmaps===!0&&C.mipmapsAutoUpdate===!0&&I.generateMipmap(Mt),ut.unbindTexture()},this.initRenderTarget=function(x){At.get(x).__webglFramebuffer===void 0&&Pt.setupRenderTarget(x)},this.initTexture=function(x){x.isCubeTexture?Pt.setTextureCube(x,0):x.isData3DTexture?Pt.setTexture3D(x,0):x.isDataArrayTexture||x.isCompressedArrayTexture?Pt.setTexture2DArray(x,0):Pt.setTexture2D(x,0),ut.unbindTexture()},this.resetState=function(){Z=0,H=0,et=null,ut.reset(),rt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return cn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorSpace=Xt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Xt._getUnpackColorSpace()}}const si=`
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler2DArray;
precision highp usampler2D;
precision highp sampler2DShadow;
`,Sl=`
uniform ivec2 anchor;                 // x and z, modulo 2^30

uint mixed(uint h) {
  h ^= h >> 16; h *= 0x7feb352du; h ^= h >> 15; h *= 0x846ca68bu; h ^= h >> 16;
  return h;
}
float unit(uint h) { return float(h >> 8) * (1.0 / 16777216.0); }
float hash2(ivec2 p) { return unit(mixed(uint(p.x) * 0x9e3779b9u ^ mixed(uint(p.y)))); }
float hash3(ivec3 p) { return unit(mixed(uint(p.x) * 0x9e3779b9u ^ mixed(uint(p.y) * 0x85ebca6bu ^ mixed(uint(p.z))))); }

/** Value noise, 0 to 1, whose cells are 2^k blocks. */
float noise(vec2 p, int k) {
  vec2 q = p / float(1 << k);
  ivec2 cell = ivec2(floor(q)) + (anchor >> k);
  vec2 f = fract(q);
  f = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  return mix(mix(hash2(cell), hash2(cell + ivec2(1, 0)), f.x), mix(hash2(cell + ivec2(0, 1)), hash2(cell + ivec2(1, 1)), f.x), f.y);
}
`,Ml=`
uniform vec3 sunDirection;            // of what lights the land: the sun, or the moon at night
uniform vec3 sunLight;
uniform vec3 skyLight;                // from above, on a level floor
uniform vec3 groundLight;             // from below
uniform vec3 zenith;
uniform vec3 horizon;
uniform vec3 glow;                    // around the sun
uniform vec3 glowDirection;           // the sun's, at night too
uniform float horizonBlocks;
uniform float fogDensity;
uniform float mist;
uniform float seaLevel;               // relative to the anchor, as y always is
uniform vec4 waterFog;                // colour; w: 1 where the camera is under water
uniform float cloudCover;
uniform vec2 cloudShift;

/** The sky without sun, moon, stars and clouds: also what distance fades to. */
vec3 skyColour(vec3 direction) {
  float up = max(direction.y, 0.0);
  vec3 colour = mix(zenith, horizon, exp(-up * 4.5));
  colour = mix(colour, horizon * 1.08, exp(-up * 16.0) * 0.6);
  float toward = dot(direction, glowDirection);
  float low = exp(-up * 5.0);
  float wide = pow(max(toward * 0.5 + 0.5, 0.0), 6.0);
  float near = pow(max(toward, 0.0), 24.0);
  return colour + glow * (wide * low * 0.55 + near * 0.35 * (0.35 + low));
}

float cloudNoise(vec2 p) {
  p += cloudShift;
  return noise(p, 9) * 0.5 + noise(p + 311.0, 8) * 0.27 + noise(p - 97.0, 7) * 0.15;
}
const float CLOUD_HEIGHT = 620.0;

/** 0 to 1: how much of the sun's light clouds leave at a place. */
float cloudShade(vec3 p) {
  vec2 at = p.xz + sunDirection.xz / max(sunDirection.y, 0.18) * (CLOUD_HEIGHT - p.y);
  return 1.0 - 0.55 * smoothstep(0.56 - cloudCover * 0.25, 0.78 - cloudCover * 0.25, cloudNoise(at) + 0.04);
}

/** What water sends itself: bright from above and around the sun, dark from the deep. */
vec3 waterColour(vec3 direction) {
  float up = direction.y * 0.5 + 0.5;
  float toSun = max(dot(direction, sunDirection), 0.0);
  return waterFog.rgb * (mix(0.45, 1.7, up * up) + 0.5 * pow(toSun, 3.0) + 0.9 * pow(toSun, 24.0));
}

/** Chunks reach past the horizon, the coarser the farther. There all has the sky's colour, but would hide its clouds, sun and stars. */
bool isBeyondHorizon(vec3 ray) { return length(ray.xz) > horizonBlocks; }

/** What the air does to light on its way. */
vec3 throughAir(vec3 colour, vec3 ray, vec3 eye) {
  float distance = length(ray);
  vec3 direction = ray / max(distance, 0.001);
  if (waterFog.w > 0.5) return mix(waterColour(direction), colour * vec3(0.42, 0.76, 0.82), exp(-distance * vec3(0.075, 0.045, 0.04)));
  float far = distance / horizonBlocks;
  float thick = far * far * 2.8 * fogDensity;
  // Mist lies low: the integral of exp(-height / 40) along the ray.
  float from = max(eye.y - seaLevel, 0.0) / 40.0;
  float to = max(eye.y + ray.y - seaLevel, 0.0) / 40.0;
  float along = abs(to - from) < 0.01 ? exp(-from) : (exp(-from) - exp(-to)) / (to - from);
  thick += mist * distance * along;
  float edge = smoothstep(0.86, 1.0, length(ray.xz) / horizonBlocks);
  float kept = exp(-thick) * (1.0 - edge);
  return mix(skyColour(normalize(vec3(direction.x, max(direction.y, 0.0) + 0.012, direction.z))), colour, kept);
}
`,wl=`
uniform float exposure;
uniform float nightly;                // 0 by day, 1 at night: eyes see less colour

/** Filmic tone curve (after Hill's fit of the ACES reference), then sRGB. */
vec3 display(vec3 light) {
  light *= exposure;
  float grey = dot(light, vec3(0.2126, 0.7152, 0.0722));
  light = mix(light, vec3(grey) * vec3(0.78, 0.94, 1.24), nightly * 0.5);
  const mat3 toRrt = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  const mat3 fromOdt = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  vec3 v = toRrt * light;
  v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  v = clamp(fromOdt * v, 0.0, 1.0);
  return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), v));
}
`,ed=`
uniform sampler2DArray ground;        // by level: height of solid ground, of liquid, in voxels of the level
uniform vec2 viewCentre;              // of what the levels surround
uniform float level0Reach;            // blocks
uniform int levels;
uniform float groundBase;             // y of row 0

int levelAt(vec2 p) {
  vec2 d = abs(p - viewCentre);
  return clamp(int(ceil(log2(max(max(d.x, d.y), 1.0) / level0Reach))), 0, levels - 1);
}
vec3 groundPlace(vec2 p, int level) {
  float scale = float(1 << level);
  vec2 size = vec2(textureSize(ground, 0).xy);
  // Levels of up to 2^6 blocks a voxel: an anchor of multiples of 4,096 is whole in all of them.
  return vec3((p / scale + vec2((anchor >> level) & (ivec2(size) - 1))) / size, float(level));
}
/** Height of the ground at p, smooth. */
float groundAt(vec2 p, int level) {
  return texture(ground, groundPlace(p, level)).r * float(1 << level) + groundBase;
}
vec2 groundVoxel(vec2 p, int level) {
  ivec3 size = textureSize(ground, 0);
  ivec2 at = (ivec2(floor(p / float(1 << level))) + (anchor >> level)) & (size.xy - 1);
  return texelFetch(ground, ivec3(at, level), 0).rg * float(1 << level) + groundBase;
}
`,nd=`
uniform sampler2DShadow shadowMap;
uniform mat4 shadowMatrix;            // from eye-relative to the map
uniform float shadowReach;            // blocks; 0: none
uniform int marchSteps;

/** By the heights of the land: soft, and as far as one sees. */
float marched(vec3 p, float from, float dither) {
  if (sunDirection.y <= 0.0) return 0.0;
  float lit = 1.0;
  float t = from * (0.85 + 0.3 * dither);
  float up = sunDirection.y / max(length(sunDirection.xz), 0.001);
  vec2 along = sunDirection.xz / max(length(sunDirection.xz), 0.001);
  for (int i = 0; i < marchSteps; i++) {
    vec2 at = p.xz + along * t;
    float over = p.y + up * t - groundAt(at, levelAt(at));
    lit = min(lit, 0.5 + over * 14.0 / (t + 24.0));
    if (lit <= 0.0 || up * t > 420.0) break;
    t *= 1.42;
  }
  return smoothstep(0.0, 1.0, lit);
}
`,Av=`${si}
uniform mat4 inverseViewProjection;
out vec3 direction;
void main() {
  // One triangle over the whole picture, at the far end.
  vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  vec4 far = inverseViewProjection * vec4(at, 1.0, 1.0);
  direction = far.xyz / far.w;
  gl_Position = vec4(at, 1.0, 1.0);
}
`,Rv=`${si}${Sl}${Ml}${wl}
uniform vec3 eye;
uniform vec3 moonDirection;
uniform float stars;
uniform mat3 starTurn;
uniform float sunDisc;
in vec3 direction;
out vec4 result;

vec3 starLight(vec3 d) {
  vec3 q = starTurn * d;
  // Cells on the faces of a cube.
  vec3 a = abs(q);
  vec2 uv = a.x > a.y && a.x > a.z ? q.yz / a.x : a.y > a.z ? q.xz / a.y : q.xy / a.z;
  int face = a.x > a.y && a.x > a.z ? (q.x > 0.0 ? 0 : 1) : a.y > a.z ? (q.y > 0.0 ? 2 : 3) : (q.z > 0.0 ? 4 : 5);
  vec2 at = uv * 70.0;
  ivec2 cell = ivec2(floor(at));
  float chance = hash3(ivec3(cell, face));
  vec2 where = vec2(hash3(ivec3(cell, face + 10)), hash3(ivec3(cell, face + 20))) * 0.7 + 0.15;
  float size = 0.03 + 0.05 * pow(hash3(ivec3(cell, face + 30)), 6.0);
  float spot = 1.0 - smoothstep(size * 0.4, size + 0.04, length(fract(at) - where));
  float warm = hash3(ivec3(cell, face + 40));
  vec3 band = vec3(0.5, 0.6, 1.0) * 0.02 * pow(1.0 - abs(dot(q, normalize(vec3(0.3, 0.5, 0.8)))), 6.0);
  return step(0.82, chance) * spot * mix(vec3(1.0, 0.85, 0.7), vec3(0.75, 0.85, 1.0), warm) * (0.25 + chance * chance) + band;
}

void main() {
  vec3 d = normalize(direction);
  vec3 colour = skyColour(d);
  if (d.y < 0.0) colour = mix(colour, horizon * 0.9, min(-d.y * 3.0, 1.0));
  float toSun = dot(d, glowDirection);
  colour += sunDisc * vec3(1.0, 0.86, 0.62) * (smoothstep(0.99955, 0.99975, toSun) * 22.0 + pow(max(toSun, 0.0), 900.0) * 2.0);
  float toMoon = dot(d, moonDirection);
  float disc = 0.0;                     // of the moon, which stars do not shine through
  if (stars > 0.0 && toMoon > 0.99) {
    vec3 right = normalize(cross(moonDirection, vec3(0.0, 0.0, 1.0)));
    vec3 upward = cross(right, moonDirection);
    vec2 m = vec2(dot(d, right), dot(d, upward)) / 0.028;
    disc = 1.0 - smoothstep(0.96, 1.02, length(m));
    float spots = noise(m * 3.0 + 40.0, 1) * 0.6 + noise(m * 7.0 + 90.0, 1) * 0.4;
    colour = mix(colour, vec3(0.95, 0.94, 0.88) * (0.55 + 0.45 * spots) * 1.3, disc * min(stars * 2.0, 1.0));
    colour += vec3(0.10, 0.12, 0.16) * stars * pow(max(toMoon, 0.0), 1200.0);
  }

  float clear = 1.0;                    // of clouds
  // Clouds on a plane high above: thick where noise is high, lit from the sun's side, lost in the distance.
  if (d.y > 0.015 && eye.y < CLOUD_HEIGHT) {
    // As of a dome, not a plane: or clouds far off would be drawn out to streaks.
    float reach = (CLOUD_HEIGHT - eye.y) / (d.y + 0.09);
    vec2 at = eye.xz + d.xz * reach;
    float fine = noise(at * 4.0 + cloudShift * 4.0, 8) * 0.09 + noise(at * 10.0 + cloudShift * 9.0, 8) * 0.06;
    float base = cloudNoise(at) + fine;
    float threshold = 0.58 - cloudCover * 0.25;
    float density = smoothstep(threshold, threshold + 0.16, base);
    float toward = cloudNoise(at + glowDirection.xz * 90.0 * sign(sunDirection.y)) + fine;
    float lit = clamp(0.75 + (base - toward) * 3.2 - (base - threshold) * 0.9, 0.0, 1.3);
    vec3 shade = horizon * 0.32 + zenith * 0.3 + skyLight * 0.18;
    float silver = pow(max(toSun, 0.0), 12.0) * (1.0 - density) * 1.6;
    vec3 cloud = mix(shade, sunLight * 0.42 + skyLight * 0.36, lit * 0.85) + glow * (0.22 * lit + silver);
    float thick = density * smoothstep(0.02, 0.16, d.y);
    colour = mix(colour, cloud, thick * 0.92);
    // A star is a point: what dims a bright sky little puts it out.
    clear = pow(1.0 - thick, 4.0);
  }
  if (stars > 0.0 && d.y > -0.02) colour += starLight(d) * stars * clear * (1.0 - disc) * smoothstep(-0.02, 0.25, d.y);
  if (waterFog.w > 0.5) colour = waterColour(d);
  // Less than a step of colour, so that gradients show no bands.
  float noisy = hash2(ivec2(gl_FragCoord.xy)) - 0.5;
  result = vec4(display(colour) + noisy / 255.0, 1.0);
}
`,yl=`
uniform usampler2D quads;
uniform sampler2D slots;              // of each mesh: origin relative to the anchor, and blocks a voxel
uniform vec3 eye;                     // relative to the anchor
uniform mat4 viewProjection;          // from eye-relative positions

struct Corner { vec3 position; vec3 normal; float occlusion; uint face; uint material; bool cut; float scale; };

Corner unpackCorner(float widen) {
  uint quad = uint(gl_VertexID) >> 2;
  uint corner = uint(gl_VertexID) & 3u;
  uvec2 word = texelFetch(quads, ivec2(int(quad & 127u), int(quad >> 7)), 0).xy;
  uint slot = word.y & 0xffffu;
  vec4 origin = texelFetch(slots, ivec2(int(slot & 255u), int(slot >> 8)), 0);

  Corner c;
  c.face = (word.x >> 15) & 7u;
  uint axis = c.face == 0u || c.face == 3u ? 0u : c.face == 2u || c.face == 5u ? 1u : 2u;
  bool positive = c.face >= 2u && c.face <= 4u;
  corner = (corner + ((word.x >> 28) & 1u)) & 3u;
  // Front faces are counter-clockwise from outside.
  if ((axis == 2u) != positive) corner = (4u - corner) & 3u;
  vec2 at = vec2(corner == 1u || corner == 2u ? 1.0 : 0.0, corner >= 2u ? 1.0 : 0.0);
  vec2 size = vec2(float((word.x >> 18) & 31u) + 1.0, float((word.x >> 23) & 31u) + 1.0);

  vec3 local = vec3(float(word.x & 31u), float((word.x >> 5) & 31u), float((word.x >> 10) & 31u));
  vec3 along = axis == 0u ? vec3(0.0, at.y * size.y, at.x * size.x)
             : axis == 1u ? vec3(at.x * size.x, 0.0, at.y * size.y)
                          : vec3(at.x * size.x, at.y * size.y, 0.0);
  vec3 out_ = axis == 0u ? vec3(1.0, 0.0, 0.0) : axis == 1u ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0);
  c.normal = positive ? out_ : -out_;
  c.scale = origin.w;
  c.position = origin.xyz - eye + (local + along + (positive ? out_ : vec3(0.0))) * origin.w;
  // Edges that meet in a T leave pixels open between them: each quad is wider by a fraction of a pixel.
  vec2 apart = (at * 2.0 - 1.0) * length(c.position) * widen;
  c.position += axis == 0u ? vec3(0.0, apart.y, apart.x) : axis == 1u ? vec3(apart.x, 0.0, apart.y) : vec3(apart.x, apart.y, 0.0);
  c.occlusion = float((word.y >> (16u + 2u * corner)) & 3u);
  c.material = (word.y >> 24) | ((word.x >> 30) << 8);
  c.cut = ((word.x >> 29) & 1u) == 1u;
  return c;
}
`,Cv=`${si}${yl}
out vec3 ray;
out float occlusion;
flat out vec3 normal;
flat out uvec2 about;                 // material, and bit 0: cut, bit 1: top, bit 2: along x
flat out float scale;
uniform float pixel;                  // its angle

void main() {
  Corner c = unpackCorner(0.4 * pixel);
  ray = c.position;
  normal = c.normal;
  occlusion = c.occlusion / 3.0;
  scale = c.scale;
  about = uvec2(c.material, (c.cut ? 1u : 0u));
  gl_Position = viewProjection * vec4(c.position, 1.0);
}
`,Pv=`${si}${Sl}${Ml}${wl}${ed}${nd}
uniform vec3 eye;
uniform sampler2D materials;          // two texels each: colour and kind; colour below, and whether flowers grow
uniform vec4 slice;                   // normal x, z, distance; w: 1 where there is one
uniform float time;
uniform float detail;                 // 0: far taps are left out
uniform float borders;
uniform vec3 selected;                // voxel, relative to the anchor; far away: none

in vec3 ray;
in float occlusion;
flat in vec3 normal;
flat in uvec2 about;
flat in float scale;
out vec4 result;

const int ROCK = 0, TURF = 1, SAND = 2, SNOW = 3, LEAVES = 4, WOOD = 5, ICE = 6, ORE = 7, RUBBLE = 8, EARTH = 9;

vec2 onFace(vec3 p) { return abs(normal.x) > 0.5 ? p.zy : abs(normal.y) > 0.5 ? p.xz : p.xy; }

/** How much of the sky is open above a place: the land's own heights around it, near and farther. */
float openness(vec3 p, vec3 n, int level, out vec2 slope) {
  vec3 q = p + n * 0.55 * scale;
  float y = q.y;
  float roof = groundAt(q.xz, level) - y;
  // Under a tree or a ledge some light comes from the sides; deep in a cave none does.
  float open = 1.0 - smoothstep(0.0, 1.6 * scale, roof) * mix(0.5, 1.0, smoothstep(5.0, 26.0, roof));
  float near = 0.0, far = 0.0;
  slope = vec2(0.0);
  float r1 = 2.2 * scale, r2 = 7.0 * scale;
  vec2 d = vec2(0.7071, 0.7071);
  for (int i = 0; i < 4; i++) {
    float beside = groundAt(q.xz + d * r1, level) - y;
    slope += d * beside;
    near += clamp(beside / (r1 * 2.2), 0.0, 1.0);
    if (detail > 0.5) far += clamp((groundAt(q.xz + vec2(d.x - d.y, d.x + d.y) * 0.7071 * r2, level) - y) / (r2 * 1.8), 0.0, 1.0);
    d = vec2(-d.y, d.x);
  }
  near *= 0.25;
  far *= 0.25;
  slope /= 2.0 * r1;
  if (abs(roof) > 4.0 * scale || length(slope) > 3.0) slope = vec2(0.0, 1e6);
  float around = 1.0 - (detail > 0.5 ? near * 0.5 + far * 0.5 : near);
  return around * (0.25 + 0.75 * open) * mix(1.0, 0.35, (1.0 - open) * near);
}

void main() {
  if (slice.w > 0.5 && dot(ray.xz, slice.xy) > slice.z + 0.02 && (about.y & 1u) == 0u) {
    // A staircase of faces stands out beyond the plane by up to a voxel.
    if (dot(ray.xz, slice.xy) > slice.z + 0.75 * scale) discard;
  }
  if (isBeyondHorizon(ray)) discard;
  vec3 p = ray + eye;
  float distance = length(ray);
  vec3 toEye = -ray / max(distance, 0.001);
  bool top = normal.y > 0.5;
  bool side = abs(normal.y) < 0.5;
  bool cut = (about.y & 1u) == 1u;

  vec4 first = texelFetch(materials, ivec2(0, int(about.x)), 0);
  vec4 second = texelFetch(materials, ivec2(1, int(about.x)), 0);
  int kind = int(first.a + 0.5);
  vec3 albedo = first.rgb;

  // Where this is: the voxel, and of its column the heights of ground and water.
  vec3 inside = p - normal * 0.5 * scale;
  ivec3 voxel = ivec3(floor(inside / scale));
  ivec3 worldVoxel = voxel + ivec3(anchor.x, 0, anchor.y) / int(scale);
  int level = int(log2(scale) + 0.5);
  vec2 column = groundVoxel(inside.xz, level);
  float depth = column.x - p.y;

  // Large areas are not flat: broad, slow changes of tint; and each voxel is itself.
  float broad = noise(p.xz, 8) * 0.55 + noise(p.xz + 57.0, 6) * 0.45;
  float mid = noise(p.xz - 31.0, 4);
  float own = hash3(worldVoxel);
  float nearly = 1.0 - smoothstep(40.0, 160.0, distance / scale);
  float grainy = 1.0 - smoothstep(14.0, 60.0, distance);

  // Texels of 1/12 block, that fade before they flicker.
  vec2 uv = onFace(p);
  ivec2 texel = ivec2(floor(uv * 12.0));
  float speck = hash2(texel + worldVoxel.xz * 7 + worldVoxel.y * 131);
  float speck2 = hash2((texel >> 1) + worldVoxel.zx * 5 + worldVoxel.y * 57);
  vec2 cell = fract(uv / scale);

  float shine = 0.0;
  float through = 0.0;                // light that leaves let through
  float swing = 0.06;
  if (kind == TURF) {
    vec3 dry = mix(albedo, albedo * vec3(1.28, 1.06, 0.55), 0.65);
    vec3 lush = albedo * vec3(0.72, 0.92, 0.66);
    albedo = mix(albedo, dry, smoothstep(0.48, 0.85, broad) * 0.75);
    albedo = mix(albedo, lush, smoothstep(0.55, 0.2, broad) * 0.6);
    albedo *= 0.9 + 0.2 * mid;
    if (side && scale < 1.5) {
      // Earth under the turf, which hangs over its edge.
      float fringe = 0.22 + 0.2 * hash2(ivec2(texel.x, worldVoxel.y) + worldVoxel.xz * 3);
      float under = smoothstep(fringe - 0.02, fringe + 0.02, depth) * (0.35 + 0.65 * grainy + (1.0 - grainy) * 0.15);
      albedo = mix(albedo, second.rgb * (0.9 + 0.2 * own), clamp(under, 0.0, 1.0) * 0.85);
    }
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.26 + (speck2 - 0.5) * 0.16);
    // Here and there a flower, in drifts of one colour.
    float meadow = smoothstep(0.45, 0.75, mid) * second.a;
    if (top && scale < 1.5 && own > 1.0 - 0.26 * meadow) {
      ivec2 bloom = texel - ivec2(floor(vec2(hash2(worldVoxel.xz), hash2(worldVoxel.zx + 9)) * 9.0 + 1.0)) - ivec2(floor(uv)) * 12;
      if (all(greaterThanEqual(bloom, ivec2(0))) && all(lessThan(bloom, ivec2(2)))) {
        float colour = noise(p.xz + 211.0, 5);
        vec3 petals = colour < 0.4 ? vec3(0.85, 0.62, 0.06) : colour < 0.52 ? vec3(0.8, 0.8, 0.75) : colour < 0.62 ? vec3(0.55, 0.08, 0.06) : vec3(0.3, 0.2, 0.6);
        albedo = mix(albedo, petals, grainy);
      }
    }
    swing = 0.07;
    through = 0.06;
  } else if (kind == SAND) {
    float ripple = sin((p.x * 0.8 + p.z * 0.35 + mid * 9.0) * 2.6);
    albedo *= 0.93 + 0.12 * broad + 0.025 * ripple * grainy;
    albedo *= 1.0 + grainy * (speck - 0.5) * 0.14;
    swing = 0.03;
  } else if (kind == SNOW) {
    albedo *= 0.92 + 0.08 * broad;
    albedo *= 1.0 + grainy * (speck - 0.5) * 0.05;
    shine = 0.25 * step(0.985, speck) * grainy;
    swing = 0.02;
  } else if (kind == LEAVES) {
    float tree = hash2((worldVoxel.xz + 3) >> 3);
    albedo *= mix(vec3(0.78, 0.9, 0.7), vec3(1.3, 1.12, 0.8), tree * 0.6 + broad * 0.4);
    // Clumps of light and shade, and gaps that go deep.
    float gap = step(0.74, speck2) * grainy;
    albedo *= (0.86 + 0.3 * own) * (1.0 + grainy * (speck - 0.5) * 0.5) * (1.0 - 0.5 * gap);
    swing = 0.0;
    through = 0.35;
  } else if (kind == WOOD) {
    float bark = hash2(ivec2(texel.x, texel.y >> 2) + worldVoxel.y * 3);
    albedo *= side ? 1.0 + grainy * (bark - 0.5) * 0.55 : 1.0 + grainy * (speck - 0.5) * 0.2;
  } else if (kind == ICE) {
    albedo *= 0.92 + 0.14 * mid;
    albedo *= 1.0 + grainy * (speck2 - 0.5) * 0.08;
    shine = 0.5;
  } else if (kind == ORE) {
    vec3 host = second.rgb * (0.92 + 0.16 * own);
    float lump = step(0.52, hash2((texel / 3) + worldVoxel.xz * 5 + worldVoxel.y * 17));
    albedo = mix(host, albedo * (0.85 + 0.5 * speck), mix(0.62, lump, grainy));
    shine = 0.35 * lump * grainy;
  } else if (kind == RUBBLE) {
    float stone = hash2((texel / 3) + worldVoxel.xz * 5 + worldVoxel.y * 17);
    albedo *= 1.0 + grainy * ((stone - 0.5) * 0.4 + (speck - 0.5) * 0.12);
    albedo *= 0.9 + 0.2 * mid;
    swing = 0.12;
  } else if (kind == EARTH) {
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.22 + (speck2 - 0.5) * 0.16);
    albedo *= 0.92 + 0.16 * mid;
  } else {
    // Rock: beds a little uneven in tone, fine level lines on walls, weathered where the sky washes it.
    float bed = hash2(ivec2(worldVoxel.y, 7 + int(floor(mid * 3.0))));
    albedo *= 0.93 + 0.12 * bed + 0.1 * (broad - 0.5);
    if (side) albedo *= 1.0 + grainy * (hash2(ivec2(texel.x >> 3, texel.y) + worldVoxel.y) - 0.5) * 0.18;
    albedo *= 1.0 + grainy * ((speck - 0.5) * 0.14 + (speck2 - 0.5) * 0.12);
    swing = 0.08;
  }
  albedo *= 1.0 + (own - 0.5) * 2.0 * swing * mix(0.45, 1.0, nearly);

  // Edges of voxels catch the light a little, and the joint between them is a little dark.
  float border = min(min(cell.x, 1.0 - cell.x), min(cell.y, 1.0 - cell.y)) * scale;
  float crisp = 1.0 - smoothstep(6.0, 34.0, distance);
  albedo *= 1.0 - 0.16 * crisp * (1.0 - smoothstep(0.0, 0.035, border)) + 0.05 * crisp * (1.0 - smoothstep(0.035, 0.1, border));
  if (all(equal(voxel, ivec3(floor(selected)))) && scale < 1.5) {
    albedo = mix(albedo, vec3(1.0), border < 0.045 ? 0.85 : 0.12);
  }

  // Light.
  vec2 slope;
  float open = openness(p, normal, level, slope);
  if (cut) open = 1.0;
  if (kind == LEAVES) open = mix(open, 1.0, 0.4);
  // A trunk stands under its own crown, which heights take for a roof.
  if (kind == WOOD) open = mix(open, 1.0, 0.5);
  float corner = mix(0.42, 1.0, occlusion * (0.35 + 0.65 * occlusion));
  if (cut) corner = 1.0;
  // Faces of voxels stand in for a rough surface: far away its lean shows, not its steps.
  // By distance alone, as the corners too: by the size of voxels shade would jump where a coarser level begins.
  vec3 lean = slope.y > 1e5 ? normal : normalize(vec3(-slope.x, 1.0, -slope.y));
  float rough = smoothstep(24.0, 190.0, distance) * 0.85;
  vec3 shading = normalize(mix(normal, lean, rough));
  // A cut is a plane, although it is made of steps.
  if (cut) shading = normalize(vec3(slice.x, 0.55, slice.y));
  corner = mix(corner, 1.0, rough * 0.55);
  float facing = cut ? 0.5 : max(dot(shading, sunDirection), 0.0);
  float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) * 0.5 + 0.25;
  float lit = 0.0;
  if (facing > 0.0 || through > 0.0) {
    float mapped = 1.0;
    vec3 start = p + normal * 0.35 * scale + sunDirection * 0.2 * scale;
    vec3 inMap = (shadowMatrix * vec4(ray + normal * (0.06 + 0.05 * distance / 60.0), 1.0)).xyz;
    float near = shadowReach > 0.0 ? 1.0 - smoothstep(shadowReach * 0.8, shadowReach, length(ray)) : 0.0;
    if (near > 0.0 && all(lessThan(abs(inMap - 0.5), vec3(0.499)))) {
      vec2 texelSize = 1.0 / vec2(textureSize(shadowMap, 0));
      mapped = 0.0;
      for (int i = 0; i < 4; i++) {
        vec2 shift = vec2(float(i & 1), float(i >> 1)) - 0.5 + (dither - 0.5) * 0.4;
        mapped += texture(shadowMap, vec3(inMap.xy + shift * texelSize * 1.5, inMap.z));
      }
      mapped *= 0.25;
    } else {
      near = 0.0;
    }
    float far = near < 1.0 || shadowReach <= 0.0 ? marched(start, 1.4 * scale, dither) : marched(start, shadowReach * 0.5, dither);
    lit = cut ? 1.0 : near > 0.0 ? mix(far, min(mapped, far), near) : far;
    lit *= cloudShade(p);
  }
  vec3 sun = sunLight * lit * mix(facing, 0.5 + 0.5 * facing, through);
  if (through > 0.0) sun *= 1.0 + through * 0.8 * pow(max(dot(-toEye, sunDirection), 0.0), 3.0);
  float up = shading.y * 0.5 + 0.5;
  vec3 ambient = mix(groundLight, skyLight, up) * (open * 0.92 + 0.08);
  // A breath of light in caves, or one would see nothing at all.
  ambient += vec3(0.012, 0.013, 0.016);
  if (side && !cut) ambient *= abs(normal.x) > 0.5 ? 0.94 : 1.04;
  vec3 light = sun * mix(corner, 1.0, 0.6) + ambient * corner;
  vec3 colour = albedo * light;
  if (shine > 0.0) {
    vec3 halfway = normalize(toEye + sunDirection);
    colour += sunLight * lit * shine * pow(max(dot(normal, halfway), 0.0), 60.0);
  }

  // Under water: what is left of the light on its way down and up, and what the water sends itself.
  // A cut below a river is seen through no water.
  float under = cut ? 0.0 : column.y - p.y;
  if (under > 0.02 && waterFog.w < 0.5) {
    float path = under * (1.0 + 0.6 / max(toEye.y, 0.25));
    colour *= exp(-vec3(0.30, 0.085, 0.06) * min(path, 40.0));
    colour += vec3(0.012, 0.075, 0.095) * (1.0 - exp(-path * 0.11)) * (sunLight * 0.28 + skyLight * 0.75);
  }
  if (under > 0.02) {
    float w = time * 0.7;
    float wave = noise(p.xz * 8.0 + vec2(w * 9.0, w * 4.0), 3) + noise(p.xz * 8.0 - vec2(w * 5.0, w * 8.0), 3);
    colour *= 1.0 + 0.7 * pow(1.0 - abs(wave - 1.0), 8.0) * lit * exp(-under * 0.16) * (1.0 - smoothstep(40.0, 120.0, distance));
  }
  // Wet where water has just been.
  if (kind == SAND && top) {
    float wet = 1.0 - smoothstep(0.3, 1.5, abs(p.y - seaLevel));
    colour *= 1.0 - 0.16 * wet;
  }
  colour = throughAir(colour, ray, eye);
  if (borders > 0.5) {
    vec2 within = fract(onFace(p - vec3(0.0, groundBase, 0.0)) / (32.0 * scale));
    float line = min(min(within.x, 1.0 - within.x), min(within.y, 1.0 - within.y)) * 32.0 * scale;
    vec3 tint = level == 0 ? vec3(1.0, 0.8, 0.2) : level == 1 ? vec3(0.2, 0.9, 1.0) : level == 2 ? vec3(1.0, 0.35, 0.8) : vec3(0.5, 1.0, 0.4);
    colour = mix(colour, tint, 0.8 * (1.0 - smoothstep(0.5, 1.0, line / max(0.06, distance * 0.0016))));
  }
  result = vec4(display(colour), 1.0);
}
`,Lv=`${si}${yl}
void main() {
  Corner c = unpackCorner(0.0);
  gl_Position = viewProjection * vec4(c.position, 1.0);
}
`,Iv=`${si}
void main() {}
`,id=.14;function Dv(i,t){const e=t+id;return{under:i(t)&&i(e),close:i(e-.5)!==i(e+.5)}}const Nv=`${si}${yl}
out vec3 ray;
flat out vec3 normal;
flat out float scale;
flat out uint material;

void main() {
  Corner c = unpackCorner(0.0);         // what is seen through must not overlap
  ray = c.position;
  // The surface lies a little below its voxel's top, at every level of detail alike.
  if (c.normal.y > 0.5) ray.y -= ${id};
  normal = c.normal;
  scale = c.scale;
  material = c.material;
  gl_Position = viewProjection * vec4(ray, 1.0);
}
`,Uv=`${si}${Sl}${Ml}${wl}${ed}${nd}
uniform vec3 eye;
uniform sampler2D materials;
uniform vec4 slice;
uniform float time;

in vec3 ray;
flat in vec3 normal;
flat in float scale;
flat in uint material;
out vec4 result;

/** Slope of the waves, of three lengths that go their own ways. */
vec2 slopeOf(vec2 p, float distance) {
  vec2 slope = vec2(0.0);
  float t = time;
  vec2 drift = vec2(t * 1.1, t * 0.6);
  for (int i = 0; i < 3; i++) {
    float fine = 1.0 - smoothstep(60.0, 500.0, distance * (i == 0 ? 1.0 : i == 1 ? 0.4 : 0.12));
    int k = i == 0 ? 1 : i == 1 ? 3 : 5;
    float size = float(1 << k);
    vec2 q = p + drift * (i == 1 ? -0.8 : 1.0) * (1.0 + float(i));
    float e = size * 0.2;
    float here = noise(q, k);
    slope += vec2(noise(q + vec2(e, 0.0), k) - here, noise(q + vec2(0.0, e), k) - here) * fine * (i == 0 ? 0.16 : i == 1 ? 0.2 : 0.16);
  }
  return slope;
}

/** The surface from under water: the sky, bent by the waves, in a round window; beyond its rim it mirrors the water. */
vec3 fromBelow(vec3 p, vec2 waves, vec3 toEye, float distance) {
  float near = 1.0 - smoothstep(20.0, 90.0, distance);
  vec2 drift = vec2(4.2, 2.1) * time;
  vec2 a = p.xz * 4.0 + drift;
  vec2 b = p.xz * 4.0 - drift.yx;
  float ripple = noise(a, 3) + noise(b, 3) - 1.0;
  vec2 ripples = vec2(noise(a + 1.5, 3) - noise(a - 1.5, 3), noise(b + 1.5, 3) - noise(b - 1.5, 3));
  // Steeper than seen from above, where the sky hides how flat they are.
  vec2 slope = waves * 3.0 + ripples * 0.16 * near;
  vec3 n = normalize(vec3(slope.x, -1.0, slope.y));
  float facing = max(dot(n, toEye), 0.0);
  float window = smoothstep(0.63, 0.75, facing);
  // Light that the waves gather: bright threads, as on the bed.
  float threads = pow(1.0 - min(abs(ripple) * 1.1, 1.0), 5.0) * (0.25 + 0.75 * near);
  vec3 mirrored = waterColour(reflect(-toEye, n)) * (0.8 + 0.5 * ripple) + waterFog.rgb * threads * 0.9;
  vec3 through = refract(-toEye, n, 1.333);
  vec3 sky = vec3(0.0);
  if (window > 0.0 && through.y > 0.0) {
    vec2 at = p.xz + through.xz * (CLOUD_HEIGHT - p.y) / (through.y + 0.09);
    float cloud = smoothstep(0.58 - cloudCover * 0.25, 0.74 - cloudCover * 0.25, cloudNoise(at));
    float toSun = max(dot(through, sunDirection), 0.0);
    sky = mix(skyColour(through), sunLight * 0.3 + skyLight * 0.4, cloud * 0.8) * (0.85 + 0.3 * threads);
    sky += sunLight * (pow(toSun, 400.0) * 8.0 + pow(toSun, 24.0) * 0.5) * (1.0 - 0.8 * cloud);
  }
  // The rim gathers all of the horizon.
  return mix(mirrored, sky, window) + horizon * 0.35 * window * (1.0 - smoothstep(0.7, 0.8, facing));
}

void main() {
  if (slice.w > 0.5 && dot(ray.xz, slice.xy) > slice.z + 0.5 * scale) discard;
  if (isBeyondHorizon(ray)) discard;
  vec3 p = ray + eye;
  float distance = length(ray);
  vec3 toEye = -ray / max(distance, 0.001);
  vec4 first = texelFetch(materials, ivec2(0, int(material)), 0);
  bool top = normal.y > 0.5;
  vec2 slope = top ? slopeOf(p.xz, distance) : vec2(0.0);
  if (waterFog.w > 0.5) {
    // Sides let the air behind them through.
    vec3 seen = top ? fromBelow(p, slope, toEye, distance) : waterColour(-toEye) * 1.2;
    result = vec4(display(throughAir(seen, ray, eye)), top ? 0.92 : 0.35);
    return;
  }
  vec3 n = top ? normalize(vec3(-slope.x, 1.0, -slope.y)) : normal;
  float facing = max(dot(n, toEye), 0.0);
  float mirror = 0.02 + 0.98 * pow(1.0 - facing, 5.0);
  vec3 away = reflect(-toEye, n);
  away.y = abs(away.y);
  vec3 seen = skyColour(away);
  // Hills stand in the mirror: where the land rises that way, it is dark.
  int level = levelAt(p.xz);
  float hill = 0.0;
  float t = 14.0;
  for (int i = 0; i < 5; i++) {
    vec2 at = p.xz + away.xz * t;
    hill = max(hill, smoothstep(-2.0, 10.0, groundAt(at, levelAt(at)) - (p.y + away.y * t)));
    t *= 2.0;
  }
  seen = mix(seen, (skyLight * 0.10 + sunLight * 0.04) * vec3(0.55, 0.7, 0.4) + seen * 0.25, hill * 0.8);
  float lit = marched(p + vec3(0.0, 0.4, 0.0), 1.5, 0.5) * cloudShade(p);
  float depth = p.y - groundAt(p.xz, level);
  float thin = max(depth, 0.0);
  vec3 body = mix(first.rgb * vec3(0.35, 0.75, 0.8), vec3(0.012, 0.085, 0.11), 0.6) * (sunLight * 0.3 * lit + skyLight * 0.8);
  float murk = (1.0 - exp(-thin * 0.10)) * 0.55 + 0.06;
  // Glitter.
  vec3 halfway = normalize(toEye + sunDirection);
  float glint = pow(max(dot(n, halfway), 0.0), 340.0) * 7.0 + pow(max(dot(n, halfway), 0.0), 60.0) * 0.25;
  // A line of foam along the shore, that comes and goes.
  float swash = noise(p.xz * 2.0 + time * 0.9, 2) * 0.6 + noise(p.xz * 4.0 - time * 0.7, 1) * 0.4;
  float foam = (1.0 - smoothstep(0.0, 0.9, thin + (swash - 0.5) * 1.1)) * step(scale, 1.5) * (1.0 - smoothstep(60.0, 260.0, distance));
  foam *= smoothstep(0.35, 0.65, swash + 0.12);
  float alpha = 1.0 - (1.0 - mirror) * (1.0 - murk);
  vec3 colour = (seen * mirror + body * (1.0 - mirror) * murk) / alpha;
  colour += sunLight * glint * lit * mirror * 6.0;
  vec3 white = (sunLight * 0.7 * lit * max(sunDirection.y, 0.0) + skyLight) * 0.75;
  colour = mix(colour, white, foam * 0.7);
  alpha = max(alpha, foam * 0.7);
  alpha = mix(alpha, 1.0, smoothstep(0.3, 1.0, distance / horizonBlocks));
  result = vec4(display(throughAir(colour, ray, eye)), alpha);
}
`;class Fv{size=0;lowest=0;rows=[];get(t){const e=t-this.lowest;return e>=0&&e<this.rows.length?this.rows[e]:void 0}set(t,e){for(this.size===0&&(this.rows.length=0,this.lowest=t);t<this.lowest;)this.rows.unshift(void 0),this.lowest--;for(;t>this.lowest+this.rows.length;)this.rows.push(void 0);this.get(t)===void 0&&this.size++,this.rows[t-this.lowest]=e}delete(t){this.get(t)!==void 0&&(this.rows[t-this.lowest]=void 0,this.size--)}values(){return this.rows.filter(t=>t!==void 0)}}const Dn=-32768;class Ov{constructor(t,e){this.column=t,this.y=e}payload=null;hash=null;material=null;arrived=0;known=0;meshedWith=-1;meshedSlice=null;changed=!1;hurried=!1;job=null;queued=!1;order=0;left=!1;drawable=null;tops=null;liquidTops=null;get lod(){return this.column.lod}get x(){return this.column.x}get z(){return this.column.z}}class kv{constructor(t,e,n){this.lod=t,this.x=e,this.z=n,this.near[4]=this}chunks=new Fv;near=Array.from({length:9});around=0;wanted=!1;drawn=!1;coveredIn=0;ready=!1;begun=!1;heights=null;liquids=null;lowest=-32768;slots=[];bottom=1/0;top=-1/0;left=0;cut=!1;skirts=0;findSkirts(){const{near:t}=this;this.skirts=(t[3]?.drawn?0:1)|(t[1]?.drawn?0:2)|(t[5]?.drawn?0:4)|(t[7]?.drawn?0:8)}gather(){this.slots.length=0,this.bottom=1/0,this.top=-1/0;for(const{drawable:t}of this.chunks.values())t!==null&&(this.slots.push(t.slot),this.bottom=Math.min(this.bottom,t.bottom),this.top=Math.max(this.top,t.top))}}class Bv{constructor(t){this.size=t,this.free=[{first:0,count:t}]}free;get freeRows(){return this.free.reduce((t,e)=>t+e.count,0)}take(t){for(let e=0;e<this.free.length;e++){const n=this.free[e];if(n.count<t)continue;const s=n.first;return n.first+=t,n.count-=t,n.count===0&&this.free.splice(e,1),s}return-1}give(t,e){let n=this.free.findIndex(o=>o.first>t);n<0&&(n=this.free.length);const s=this.free[n-1],r=this.free[n];s!==void 0&&s.first+s.count===t?(s.count+=e,r!==void 0&&s.first+s.count===r.first&&(s.count+=r.count,this.free.splice(n,1))):r!==void 0&&t+e===r.first?(r.first=t,r.count+=e):this.free.splice(n,0,{first:t,count:e})}}const In=128,Oa=2048,Or=In*Oa,zv=Or*8;function Hv(){const i=new Uint32Array(Or*6);for(let t=0,e=0;t<Or;t++){const n=t*4;i[e++]=n,i[e++]=n+1,i[e++]=n+2,i[e++]=n,i[e++]=n+2,i[e++]=n+3}return new je(i,1)}class Gv extends yn{isBatchedMesh=!0;_colorsTexture=null;_multiDrawInstances=null;_multiDrawStarts=new Int32Array(1024);_multiDrawCounts=new Int32Array(1024);_multiDrawCount=0;constructor(t,e){super(t,e),this.frustumCulled=!1,this.matrixAutoUpdate=!1}empty(){this._multiDrawCount=0}push(t,e){const n=this._multiDrawCount;if(n>0&&this._multiDrawStarts[n-1]/24+this._multiDrawCounts[n-1]/6===t){this._multiDrawCounts[n-1]+=e*6;return}if(n===this._multiDrawStarts.length){const s=new Int32Array(n*2);s.set(this._multiDrawStarts),this._multiDrawStarts=s;const r=new Int32Array(n*2);r.set(this._multiDrawCounts),this._multiDrawCounts=r}this._multiDrawStarts[n]=t*24,this._multiDrawCounts[n]=e*6,this._multiDrawCount=n+1}}class Vv{constructor(t){this.renderer=t,this.geometry.setIndex(Hv()),this.addPage()}pages=[];geometry=new bn;get bytes(){return this.pages.length*zv+Or*24}add(t){const e=Math.ceil(t.length/2/In);let n=0,s=-1;for(;n<this.pages.length&&(s=this.pages[n].ranges.take(e),!(s>=0));n++);return s<0&&(n=this.pages.length,this.addPage(),s=this.pages[n].ranges.take(e)),this.upload(this.pages[n].texture,s,e,t),{page:n,firstQuad:s*In,rows:e}}remove(t){this.pages[t.page].ranges.give(t.firstQuad/In,t.rows)}dispose(){for(const t of this.pages)t.texture.dispose();this.geometry.dispose()}addPage(){const t=new Kr(null,In,Oa,$r,tn);t.internalFormat="RG32UI",t.minFilter=t.magFilter=me,t.source.dataReady=!1,t.needsUpdate=!0,this.pages.push({texture:t,ranges:new Bv(Oa)})}upload(t,e,n,s){const r=El(this.renderer,t),o=Math.floor(s.length/2/In),a=In*2;o>0&&r.texSubImage2D(r.TEXTURE_2D,0,0,e,In,o,r.RG_INTEGER,r.UNSIGNED_INT,s,0);const l=s.length/2-o*In;n>o&&r.texSubImage2D(r.TEXTURE_2D,0,0,e+o,l,1,r.RG_INTEGER,r.UNSIGNED_INT,s,o*a)}}function El(i,t,e=3553){const n=i.getContext();i.initTexture(t);const{__webglTexture:s}=i.properties.get(t);i.state.activeTexture(n.TEXTURE0),i.state.bindTexture(e,s);const r=i.state,o=r.pixelStorei?.bind(r)??n.pixelStorei.bind(n);return o(n.UNPACK_FLIP_Y_WEBGL,!1),o(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),o(n.UNPACK_ALIGNMENT,1),n}const sd=Fu.toHalfFloat(-2048),ws=2047,Wv=Uint16Array.from({length:2*ws+1},(i,t)=>Fu.toHalfFloat(t-ws)),Xv=4;class qv{constructor(t,e,n,s){this.renderer=t,this.levels=n,this.base=s,this.size=th(e);const r=new gl(null,this.size,this.size,n);r.format=ii,r.type=dn,r.internalFormat="RG16F",r.minFilter=r.magFilter=Ie,r.wrapS=r.wrapT=Rr,r.source.dataReady=!1,r.needsUpdate=!0,this.texture=r,this.clear()}texture;size;part=new Uint16Array(1024*2);isFor(t,e,n){return this.size===th(t)&&this.levels===e&&this.base===n}get bytes(){return this.size*this.size*this.levels*Xv}set(t){if(t.lod>=this.levels)return;const e=this.base>>t.lod,{heights:n,liquids:s}=t;for(let a=0;a<1024;a++)this.part[2*a]=eh(n?.[a]??Dn,e),this.part[2*a+1]=eh(s?.[a]??Dn,e);const r=this.size/32,o=a=>(a%r+r)%r*32;this.write(o(t.x),o(t.z),t.lod,32,32,this.part)}clear(){const t=new Uint16Array(this.size*64*2).fill(sd);for(let e=0;e<this.levels;e++)for(let n=0;n<this.size;n+=64)this.write(0,n,e,this.size,64,t)}dispose(){this.texture.dispose()}write(t,e,n,s,r,o){const a=El(this.renderer,this.texture,35866);a.texSubImage3D(a.TEXTURE_2D_ARRAY,0,t,e,n,s,r,1,a.RG,a.HALF_FLOAT,o)}}const th=i=>(2*i+3)*32<=1024?1024:2048;function eh(i,t){return i===Dn?sd:Wv[Math.min(Math.max(i-t,-ws),ws)+ws]}const $v=`
precision highp float;
uniform mat4 viewProjection;
uniform vec3 low;
uniform vec3 size;
uniform float thickness;
in vec3 corner;
in vec3 offset;
void main() {
  // A little outside of the voxels' faces, so that both do not fight for the same pixels.
  vec3 outward = (corner * 2.0 - 1.0) * 0.004;
  gl_Position = viewProjection * vec4(low + corner * size + outward + offset * thickness, 1.0);
}
`,Yv=`
precision highp float;
uniform vec4 colour;
out vec4 result;
void main() { result = colour; }
`,rd=i=>[i&1,i>>1&1,i>>2&1],od=[0,2,1,1,2,3,4,5,6,5,7,6,0,1,4,1,5,4,2,6,3,3,6,7,0,4,2,2,4,6,1,3,5,3,7,5];function ad(i,t,e){const n=new bn;return n.setAttribute("position",new je(new Float32Array(i.length),3)),n.setAttribute("corner",new je(new Float32Array(i),3)),n.setAttribute("offset",new je(new Float32Array(t),3)),n.setIndex(e),n}function Kv(){const i=Array.from({length:8},(t,e)=>rd(e)).flat();return ad(i,new Array(24).fill(0),od)}function Zv(){const[i,t,e]=[[],[],[]];for(let n=0;n<3;n++)for(let s=0;s<4;s++){const r=i.length/3;for(let o=0;o<8;o++){const[a,l,c]=rd(o),h=[s&1,s>>1],d=[a,l,c].map((u,f)=>f===n?u:h[f===(n+1)%3?0:1]);i.push(...d),t.push(2*a-1,2*l-1,2*c-1)}e.push(...od.map(o=>r+o))}return ad(i,t,e)}class Jv{scene=new Ms;box;colours=[new zt,new zt];parts;constructor(t){this.box={viewProjection:t,low:{value:new U},size:{value:new U},thickness:{value:.01}},this.parts=[Kv(),Zv()].map(e=>{const n={...this.box,colour:{value:[1,1,1,1]}},s=new ki({glslVersion:fi,vertexShader:$v,fragmentShader:Yv,uniforms:n,transparent:!0,depthWrite:!1}),r=new yn(e,s);return r.frustumCulled=!1,this.scene.add(r),r})}draw(t,e,n,s){const{first:r,last:o}=n,a=this.box.low.value,l=this.box.size.value;a.set(r.x-s.x,r.y-s.y,r.z-s.z),l.set(o.x+1-r.x,o.y+1-r.y,o.z+1-r.z),this.box.thickness.value=.006+.0014*Math.hypot(a.x+l.x/2,a.y+l.y/2,a.z+l.z/2),[n.colour,n.edge].forEach((c,h)=>{const{r:d,g:u,b:f}=this.colours[h].setHex(c,Nn);this.parts[h].material.uniforms.colour.value=[d,u,f,h===0?n.veil:.95]}),t.render(this.scene,e)}dispose(){for(const{geometry:t,material:e}of this.parts)t.dispose(),e.dispose()}}const Qv=[["leaves|needles|bush|hedge|foliage","leaves"],["wood|bark|log|trunk|timber|plank","wood"],["\\bice\\b|glacier","ice"],["snow|firn","snow"],["\\bore\\b|coal|copper|silver|gold|iron\\b|crystal","ore"],["scree|gravel|shingle|pebble|rubble|cobble|talus","rubble"],["sandstone|limestone","rock"],["beach|desert$|\\bsand\\b|dune|sea floor","sand"],["grass|meadow|forest|jungle|taiga|tundra|savanna|moss|turf|heath|steppe|prairie|cactus","turf"],["soil|dirt|earth|clay|mud|peat|loam|humus","earth"]],jv=[{look:"turf",grey:.18,times:[.95,.9,.86]},{look:"wood",grey:.3,times:[1.1,1.1,1.1]},{look:"snow",grey:0,times:[.8,.83,.87]}],tx=[{at:-.3,sunLight:["#a9c0ff",.34],skyLight:["#3a5090",.7],zenith:["#04081a",1],horizon:["#0f1c38",1],glow:["#000000",0],exposure:2.1},{at:-.14,sunLight:["#a9c0ff",.2],skyLight:["#7078a8",1.25],zenith:["#0a1436",1],horizon:["#2c3a68",.9],glow:["#a0483a",.45],exposure:2},{at:-.03,sunLight:["#ff8a4a",.1],skyLight:["#8088b8",.85],zenith:["#1c3070",1],horizon:["#7d7090",.75],glow:["#ff6e32",1.35],exposure:1.7},{at:.06,sunLight:["#ff9a52",2.3],skyLight:["#8c98c8",.85],zenith:["#34589e",1],horizon:["#cbaaa4",.82],glow:["#ff8a3c",1.3],exposure:1.25},{at:.22,sunLight:["#ffc58a",3.7],skyLight:["#9db0d4",1.05],zenith:["#3a74c4",1],horizon:["#e2d8d4",1.05],glow:["#ffb870",.7],exposure:.9},{at:.5,sunLight:["#ffe6c2",4.3],skyLight:["#a2bade",1.4],zenith:["#3b7dd6",1.05],horizon:["#cfe2f2",1.3],glow:["#ffe2b8",.35],exposure:.75},{at:1,sunLight:["#fff2dc",4.6],skyLight:["#a2bade",1.55],zenith:["#3879d6",1.1],horizon:["#c6def4",1.45],glow:["#fff0d8",.25],exposure:.69}],bl={looks:Qv,tints:jv,light:tx},ex=bl.light,nx=bl.looks.map(([i,t])=>[new RegExp(i),t]),ix=new Map(bl.tints.map(({look:i,grey:t,times:e})=>[i,{grey:t,times:e}])),rs=([i,t])=>{const e=new zt(i);return[e.r*t,e.g*t,e.b*t]},sr=ex.map(({at:i,exposure:t,...e})=>({at:i,exposure:t,sunLight:rs(e.sunLight),skyLight:rs(e.skyLight),zenith:rs(e.zenith),horizon:rs(e.horizon),glow:rs(e.glow)})),os=(i,t,e)=>new U(...i.map((n,s)=>n+(t[s]-n)*e)),as=(i,t,e)=>{const n=Math.min(Math.max((e-i)/(t-i),0),1);return n*n*(3-2*n)};function nh(i){const t=(i-6)/24*2*Math.PI,e=.55,n=new U(Math.cos(t),Math.sin(t)*Math.cos(e),Math.sin(t)*Math.sin(e)).normalize(),s=new U(-n.x,-n.y*.9,n.z*.2+.35).normalize(),r=n.y;let o=0;for(;o<sr.length-2&&r>sr[o+1].at;)o++;const a=sr[o],l=sr[o+1],c=Math.min(Math.max((r-a.at)/(l.at-a.at),0),1),h=r>-.05,d=h?as(-.05,.03,r):as(-.05,-.16,r),u=h?n.clone():s.clone();u.y=Math.max(u.y,.035),u.normalize();const f=os(a.sunLight,l.sunLight,c).multiplyScalar(d),v=os(a.skyLight,l.skyLight,c),S=new Lt().setFromMatrix4(new Zt().makeRotationAxis(new U(0,Math.sin(.7),Math.cos(.7)).normalize(),-t));return{direction:u,sun:n,moon:s,sunLight:f,skyLight:v,groundLight:v.clone().multiply(new U(.42,.36,.28)).addScaledVector(new U(f.x*.075,f.y*.065,f.z*.045),Math.max(u.y,0)+.2),zenith:os(a.zenith,l.zenith,c),horizon:os(a.horizon,l.horizon,c),glow:os(a.glow,l.glow,c),exposure:a.exposure+(l.exposure-a.exposure)*c,stars:as(-.1,-.25,r),night:as(0,-.18,r),mist:3e-4+.0016*(1-as(.08,.4,Math.abs(r))),starTurn:S}}const sx=1024,vs=65536,rx=[{axis:0,sign:-1},{axis:2,sign:-1},{axis:1,sign:1},{axis:0,sign:1},{axis:2,sign:1},{axis:1,sign:-1}],[ox,ax,Sy,lx,cx]=[0,1,2,3,4,5],hx=[ox,ax,lx,cx],ux=rx.length+hx.length,ih=32,dx=(i,t,e)=>(t*ih+e)*ih+i,rr=(i,t,e)=>(t-i.x)*i.nx+(e-i.z)*i.nz;function ka(i,t,e,n){const s=[rr(i,t,e),rr(i,t+n,e),rr(i,t,e+n),rr(i,t+n,e+n)];return Math.max(...s)<=0?"kept":Math.min(...s)>=0?"gone":"cut"}const sh=16,Ba=0,za=1,Er=2,Ha=13,Ga=14;class fx{values=new Int32Array(vs*sh);at(t){return t*sh}set(t,{page:e,firstQuad:n},{counts:s},r,o){const a=this.at(t);this.values[a+Ba]=e,this.values[a+za]=n,this.values.set(s,a+Er),this.values[a+Ha]=r,this.values[a+Ga]=o}}const ls=256,No=4096;function rh(i){const t=i.elements,e=new Float64Array(24);for(let n=0;n<6;n++){const s=n>>1,r=n&1?-1:1;for(let o=0;o<4;o++)e[n*4+o]=t[o*4+3]+r*t[o*4+s]}return e}class px{constructor(t,e){this.renderer=t,this.makeMaterial=e,this.pages=new Vv(t),this.slots=new Kr(this.slotData,ls,vs/ls,Qe,Je),this.slots.minFilter=this.slots.magFilter=me,this.slots.needsUpdate=!0;for(const n of[this.solid,this.liquid,this.shadow])n.matrixWorldAutoUpdate=!1;this.addPage()}solid=new Ms;liquid=new Ms;shadow=new Ms;slots;anchor={x:0,y:0,z:0};meshes=0;quads=0;lowest=1/0;highest=-1/0;pages;slotData=new Float32Array(vs*4);staleSlotRows=new Set;table=new fx;used=[];freeSlots=[];sets=[];get bytes(){return this.pages.bytes+vs*16}takeSlot(t,e,n,s){const r=this.freeSlots.pop()??this.used.length;if(r>=vs)throw new Error("the view has more meshes than there are slots; make it smaller");return this.used[r]={lod:t,x:e,y:n,z:s},this.writeSlot(r),this.staleSlotRows.add(Math.floor(r/ls)),r}uploadSlots(){if(this.staleSlotRows.size===0)return;const t=El(this.renderer,this.slots);for(const e of this.staleSlotRows)t.texSubImage2D(t.TEXTURE_2D,0,0,e,ls,1,t.RGBA,t.FLOAT,this.slotData,e*ls*4);this.staleSlotRows.clear()}freeSlot(t){this.used[t]=null,this.freeSlots.push(t)}add(t,e){const n=this.pages.add(e.quads);for(;this.sets.length<=n.page;)this.addPage();const{lod:s,y:r}=this.used[t],o=2**s,a=e.quads.length/2;this.meshes++,this.quads+=a;const[l,c]=[(r*32+e.low)*o,(r*32+e.high+1)*o];return this.lowest=Math.min(this.lowest,l),this.highest=Math.max(this.highest,c),this.table.set(t,n,e,l,c),{slot:t,place:n,quads:a,bottom:l,top:c}}remove(t){this.pages.remove(t.place),this.freeSlot(t.slot),this.meshes--,this.quads-=t.quads}setAnchor(t,e,n){this.anchor={x:t,y:e,z:n};for(let s=0;s<this.used.length;s++)this.used[s]&&this.writeSlot(s);this.slots.needsUpdate=!0}list({columns:t,squares:e},n,s,r,o){for(const d of this.sets)d.solid.empty(),d.liquid.empty();const a=rh(s),{values:l}=this.table,[c,h]=[this.lowest-n.y,this.highest-n.y];for(let d=0;d<t.length;d++){const u=e[3*d+2],f=e[3*d]-n.x,v=e[3*d+1]-n.z;if(!cs(a,f,c,v,u,h))continue;const S=t[d];if(r!==null&&ka(r,S.x*u,S.z*u,u)==="gone"||!cs(a,f,S.bottom-n.y,v,u,S.top-n.y))continue;const p=o&&S.ready&&(S.lod>0||f*f+v*v>25600)?(S.lowest-6)*2**S.lod:-1/0;for(const M of S.slots){const A=this.table.at(M),E=l[A+Ga];if(E<p)continue;const R=l[A+Ha]-n.y,b=E-n.y;cs(a,f,R,v,u,b)&&this.push(A,f,R,v,u,b,S.skirts)}}}listShadow(t,e,n,s,r){for(const l of this.sets)l.shadow.empty();const o=rh(n),{values:a}=this.table;for(const l of t){if(l.lod>1)continue;const c=32*2**l.lod,h=l.x*c-e.x,d=l.z*c-e.z;if(!(r!==null&&ka(r,l.x*c,l.z*c,c)==="gone")&&cs(o,h,l.bottom-e.y,d,c,l.top-e.y))for(const u of l.slots){const f=this.table.at(u),[v,S]=[a[f+Ha],a[f+Ga]];if(l.ready&&S<(l.lowest-2)*2**l.lod||!cs(o,h,v-e.y,d,c,S-e.y))continue;const m=this.sets[a[f+Ba]].shadow;let p=a[f+za];for(let M=0;M<6;M++){const A=M===0?s.x<0:M===3?s.x>0:M===1?s.z<0:M===4?s.z>0:M===2,E=a[f+Er+M];A&&E>0&&m.push(p,E),p+=E}}}}get isListed(){return this.sets.some(({solid:t,liquid:e})=>t._multiDrawCount+e._multiDrawCount>0)}dispose(){this.pages.dispose(),this.slots.dispose();for(const{solid:t,liquid:e,shadow:n}of this.sets)for(const s of[t,e,n])s.material.dispose()}push(t,e,n,s,r,o,a){const{values:l}=this.table,c=this.sets[l[t+Ba]];let h=l[t+za];for(let u=0;u<10;u++){const f=l[t+Er+u];if(f>0){const v=u<6?u:u-6<2?u-6:u-5;(v===0?e+r>0:v===3?e<0:v===1?s+r>0:v===4?s<0:v===2?n<0:o>0)&&(u<6||a>>u-6&1)&&c.solid.push(h,f),h+=f}}const d=l[t+Er+ux];d>0&&c.liquid.push(h,d)}addPage(){const t=this.sets.length,e=(n,s)=>{const r=this.makeMaterial(n);r.uniforms.quads={value:this.pages.pages[t].texture},r.uniforms.slots={value:this.slots};const o=new Gv(this.pages.geometry,r);return s.add(o),o};this.sets.push({solid:e("solid",this.solid),liquid:e("liquid",this.liquid),shadow:e("shadow",this.shadow)})}writeSlot(t){const{lod:e,x:n,y:s,z:r}=this.used[t],o=2**e;this.slotData[t*4]=n*32*o-this.anchor.x,this.slotData[t*4+1]=s*32*o-this.anchor.y,this.slotData[t*4+2]=r*32*o-this.anchor.z,this.slotData[t*4+3]=o}}function cs(i,t,e,n,s,r){for(let o=0;o<24;o+=4){const a=i[o],l=i[o+1],c=i[o+2];if(a*(a>0?t+s:t)+l*(l>0?r:e)+c*(c>0?n+s:n)+i[o+3]<0)return!1}return!0}const oh=new U(1e9,1e9,1e9),ah=.12,mx=.03;class gx{renderer;terrain;ground=null;light=nh(10);triangles=0;drawCalls=0;camera=new an(70,1,ah,8e3);viewProjection=new Zt;sky=new Ms;uniforms;shadowUniforms;shadowTarget=null;shadowCentre=new U(1/0,0,0);shadowDirection=new U;shadowMatrix=new Zt;shadowAt=-1/0;shadowStale=!0;shadowReach=0;skyMaterial;marker;disposed=!1;constructor(t,e){this.renderer=new Tv({canvas:t,antialias:e==="high",powerPreference:"high-performance",stencil:!1,alpha:!1}),this.renderer.autoClear=!1,this.renderer.sortObjects=!1,this.renderer.info.autoReset=!1,this.renderer.debug.checkShaderErrors=!1,this.uniforms={eye:{value:new U},viewProjection:{value:this.viewProjection},pixel:{value:.001},inverseViewProjection:{value:new Zt},anchor:{value:new $t},materials:{value:null},ground:{value:null},viewCentre:{value:new $t},level0Reach:{value:400},levels:{value:1},groundBase:{value:0},shadowMap:{value:null},shadowMatrix:{value:new Zt},shadowReach:{value:0},marchSteps:{value:12},slice:{value:new ce},time:{value:0},detail:{value:1},borders:{value:0},selected:{value:oh.clone()},sunDirection:{value:new U},sunLight:{value:new U},skyLight:{value:new U},groundLight:{value:new U},zenith:{value:new U},horizon:{value:new U},glow:{value:new U},glowDirection:{value:new U},moonDirection:{value:new U},horizonBlocks:{value:4096},fogDensity:{value:1},mist:{value:0},seaLevel:{value:0},waterFog:{value:new ce},cloudCover:{value:.5},cloudShift:{value:new $t},exposure:{value:1},nightly:{value:0},stars:{value:0},starTurn:{value:new Lt},sunDisc:{value:1}},this.marker=new Jv(this.uniforms.viewProjection),this.shadowUniforms={eye:{value:new U},viewProjection:{value:new Zt}},this.terrain=new px(this.renderer,r=>this.makeMaterial(r)),this.skyMaterial=new ki({glslVersion:fi,vertexShader:Av,fragmentShader:Rv,uniforms:this.uniforms,depthWrite:!1});const n=new bn;n.setAttribute("position",new je(new Float32Array(9),3));const s=new yn(n,this.skyMaterial);s.frustumCulled=!1,this.sky.add(s),this.setQuality(e),this.warmUp()}async warmUp(){const t=[this.terrain.solid,this.sky,this.terrain.liquid],e=t.map(n=>this.renderer.compileAsync(n,this.camera));if(this.shadowReach>0&&(this.renderer.setRenderTarget(this.shadowTarget),t.push(this.terrain.shadow),e.push(this.renderer.compileAsync(this.terrain.shadow,this.camera)),this.renderer.setRenderTarget(null)),await Promise.all(e),!(this.disposed||this.renderer.getContext().isContextLost()))for(const n of t)n.traverse(s=>this.readProgram(s))}readProgram(t){const e=t.material;if(e===void 0)return;const{currentProgram:n}=this.renderer.properties.get(e);n?.getUniforms()}get gpuBytes(){const t=this.shadowTarget===null?0:this.shadowTarget.width**2*8;return this.terrain.bytes+(this.ground?.bytes??0)+t}setQuality(t){this.set("detail",t==="high"?1:0),this.set("marchSteps",t==="high"?14:8),this.shadowTarget?.depthTexture?.dispose(),this.shadowTarget?.dispose(),this.shadowTarget=null,this.shadowReach=t==="high"?120:0;const e=t==="high"?2048:1,n=new Si(e,e,tn);n.compareFunction=fl,n.minFilter=n.magFilter=Ie,this.shadowTarget=new un(e,e,{depthTexture:n,depthBuffer:!0,stencilBuffer:!1}),this.set("shadowMap",n),this.set("shadowReach",this.shadowReach),this.shadowStale=!0}setMaterials(t){this.uniforms.materials.value?.dispose(),this.set("materials",t)}setGround(t){this.ground?.dispose(),this.ground=t,this.set("ground",t?.texture??null),this.set("levels",t?.levels??1)}setReach(t,e,n,s){this.viewCentre.set(t,e),this.set("level0Reach",n),this.set("horizonBlocks",s),this.camera.far=s*1.6+1e3,this.camera.updateProjectionMatrix()}viewCentre=new $t;setTimeOfDay(t){this.light=nh(t),this.shadowStale=!0}setBorders(t){this.set("borders",t?1:0)}setFov(t){this.camera.fov=t,this.camera.updateProjectionMatrix(),this.measurePixel()}resize(t,e,n){this.renderer.setPixelRatio(n),this.renderer.setSize(t,e,!1),this.camera.aspect=t/Math.max(e,1),this.camera.updateProjectionMatrix(),this.measurePixel()}measurePixel(){this.set("pixel",2*Math.tan(this.camera.fov*Math.PI/360)/Math.max(this.renderer.domElement.height,1))}contextRestored(){this.terrain.slots.needsUpdate=!0,this.ground=null,this.shadowStale=!0,this.shadowAt=-1/0}landChanged(){this.shadowStale=!0}draw(t){const{eye:e,columns:n,slice:s}=t;this.moveAnchor(e);const r=this.terrain.anchor,o=this.uniforms;if(o.eye.value.set(e.x-r.x,e.y-r.y,e.z-r.z),o.anchor.value.set(r.x%2**30,r.z%2**30),o.viewCentre.value.set(this.viewCentre.x-r.x,this.viewCentre.y-r.z),this.set("groundBase",t.groundBase-r.y),this.set("seaLevel",(t.seaLevel??-1e6)-r.y),this.set("time",t.seconds%3600),o.cloudShift.value.set(t.seconds*2.2%131072,t.seconds*.9%131072),o.selected.value.copy(oh),t.selected){const{x:d,y:u,z:f}=t.selected;o.selected.value.set(d-r.x,u-r.y,f-r.z)}o.slice.value.set(s?.nx??0,s?.nz??0,s===null?0:(s.x-e.x)*s.nx+(s.z-e.z)*s.nz,s===null?0:1),this.applyLight(t.underWater);const l=t.closeToWater?mx:ah;this.camera.near!==l&&(this.camera.near=l,this.camera.updateProjectionMatrix()),this.camera.rotation.set(e.pitch,-e.yaw,0,"YXZ"),this.camera.updateMatrixWorld(!0),this.viewProjection.multiplyMatrices(this.camera.projectionMatrix,this.camera.matrixWorldInverse),o.inverseViewProjection.value.copy(this.viewProjection).invert();const{renderer:c,terrain:h}=this;return h.list(n,e,this.viewProjection,s,t.hideBuried),t.onlyWithLand&&!h.isListed?!1:(c.info.reset(),h.uploadSlots(),this.castShadows(e,n.columns,t.now,s),c.setRenderTarget(null),c.clear(!0,!0,!1),c.render(h.solid,this.camera),c.render(this.sky,this.camera),c.render(h.liquid,this.camera),t.marker!==null&&this.marker.draw(c,this.camera,t.marker,e),this.triangles=c.info.render.triangles,this.drawCalls=c.info.render.calls,!0)}dispose(){this.disposed=!0,this.terrain.dispose(),this.setGround(null),this.skyMaterial.dispose(),this.marker.dispose(),this.uniforms.materials.value?.dispose(),this.shadowTarget?.depthTexture?.dispose(),this.shadowTarget?.dispose(),this.renderer.dispose()}set(t,e){this.uniforms[t].value=e}makeMaterial(t){return t==="shadow"?new ki({glslVersion:fi,vertexShader:Lv,fragmentShader:Iv,uniforms:{...this.shadowUniforms},side:ei,colorWrite:!1,polygonOffset:!0,polygonOffsetFactor:1.5,polygonOffsetUnits:2}):t==="liquid"?new ki({glslVersion:fi,vertexShader:Nv,fragmentShader:Uv,uniforms:{...this.uniforms},side:xn,transparent:!0,forceSinglePass:!0}):new ki({glslVersion:fi,vertexShader:Cv,fragmentShader:Pv,uniforms:{...this.uniforms}})}moveAnchor(t){const e=this.terrain.anchor;if(Math.max(Math.abs(t.x-e.x),Math.abs(t.z-e.z),Math.abs(t.y-e.y))<=No)return;const s=r=>Math.round(r/No)*No;this.terrain.setAnchor(s(t.x),s(t.y),s(t.z))}applyLight(t){const e=this.light;for(const r of["sunLight","skyLight","groundLight","zenith","horizon","glow"])this.uniforms[r].value.copy(e[r]);this.uniforms.sunDirection.value.copy(e.direction),this.uniforms.glowDirection.value.copy(e.sun),this.uniforms.moonDirection.value.copy(e.moon),this.uniforms.starTurn.value.copy(e.starTurn),this.set("exposure",e.exposure),this.set("nightly",e.night),this.set("stars",e.stars),this.set("sunDisc",e.sun.y>-.05?1:0),this.set("mist",e.mist);const n=this.uniforms.waterFog.value,s=.52*(e.sunLight.y*.3+e.skyLight.y);n.set(.05*s,.42*s,.5*s,t?1:0)}castShadows(t,e,n,s){const r=this.shadowTarget;if(r===null)return;if(this.shadowReach===0){this.shadowStale&&this.renderer.initRenderTarget(r),this.shadowStale=!1;return}const o=this.light.direction;if(!(Math.hypot(t.x-this.shadowCentre.x,t.y-this.shadowCentre.y,t.z-this.shadowCentre.z)<24)||o.distanceToSquared(this.shadowDirection)>1e-6||this.shadowStale&&n-this.shadowAt>400){this.shadowStale=!1,this.shadowAt=n,this.shadowDirection.copy(o),this.shadowCentre.set(Math.floor(t.x),Math.floor(t.y),Math.floor(t.z));const d=this.shadowReach+28,u=new Zt().lookAt(o,new U,new U(0,1,.001)).setPosition(0,0,0).invert(),f=420,v=new Zt().makeOrthographic(-d,d,d,-d,-f,f);this.shadowMatrix.multiplyMatrices(v,u);const S=this.terrain.anchor;this.shadowUniforms.eye.value.set(this.shadowCentre.x-S.x,this.shadowCentre.y-S.y,this.shadowCentre.z-S.z),this.shadowUniforms.viewProjection.value.copy(this.shadowMatrix),this.terrain.listShadow(e,this.shadowCentre,this.shadowMatrix,o,s),this.renderer.setRenderTarget(r),this.renderer.clear(!1,!0,!1),this.renderer.render(this.terrain.shadow,this.camera)}const c=new Zt().makeScale(.5,.5,.5).setPosition(.5,.5,.5).multiply(this.shadowMatrix),h=new Zt().makeTranslation(t.x-this.shadowCentre.x,t.y-this.shadowCentre.y,t.z-this.shadowCentre.z);this.uniforms.shadowMatrix.value.multiplyMatrices(c,h)}}const _x={rock:0,turf:1,sand:2,snow:3,leaves:4,wood:5,ice:6,ore:7,rubble:8,earth:9};function vx(i){const t=i.name.toLowerCase();for(const[e,n]of nx)if(e.test(t))return n;return"rock"}function xx(i,t){const e=ix.get(t);if(e===void 0)return;const n=i.r*.32+i.g*.6+i.b*.08,[s,r,o]=e.times;i.lerp(new zt().setRGB(n,n,n),e.grey),i.setRGB(i.r*s,i.g*r,i.b*o)}function Sx(i){const t=new Float32Array(i.length*8),e=new zt,n=new zt(i.find(o=>/soil|dirt|earth/.test(o.name))?.colour??8018750),s=new zt(i.find(o=>o.phase==="solid")?.colour??7762038);i.forEach((o,a)=>{const l=vx(o);e.set(o.colour),xx(e,l);const c=l==="ore"?s:/cactus/.test(o.name)?e:n;t.set([e.r,e.g,e.b,_x[l],c.r,c.g,c.b,/meadow|forest|grass|heath|taiga/.test(o.name)?1:0],a*8)});const r=new Kr(t,2,i.length,Qe,Je);return r.minFilter=r.magFilter=me,r.needsUpdate=!0,r}const Mx=32,wx=16,Uo=1024;class yx{version=-1;x=0;z=0;columns=[];squares=new Float64Array;unsorted=[];steps=[];ends=new Uint32Array(Uo);update(t,e,n,s){return e===this.version&&Math.abs(n-this.x)+Math.abs(s-this.z)<=Mx?this:(this.version=e,this.x=n,this.z=s,this.sort(t),this.measure(),this)}sort(t){const{columns:e,unsorted:n,steps:s,ends:r}=this;r.fill(0);let o=0;for(const a of t){const l=this.stepOf(a);n[o]=a,s[o++]=l,r[l]++}for(let a=1;a<Uo;a++)r[a]+=r[a-1];e.length=n.length=o;for(let a=o-1;a>=0;a--)e[--r[s[a]]]=n[a]}measure(){const{columns:t}=this;this.squares.length<3*t.length&&(this.squares=new Float64Array(6*t.length));const{squares:e}=this;for(let n=0;n<t.length;n++){const{lod:s,x:r,z:o}=t[n],a=32*2**s;e[3*n]=r*a,e[3*n+1]=o*a,e[3*n+2]=a}}stepOf(t){const e=32*2**t.lod,n=Math.hypot((t.x+.5)*e-this.x,(t.z+.5)*e-this.z)-e/2;return Math.min(Uo-1,Math.max(0,Math.floor(n/wx)))}}class Ex{constructor(t,e){this.predictions=t,this.client=e}async edit(t,e,n){const s=this.predictions.begin(n);try{const r=await t.edit(e);return this.predictions.settled(s,r.revision,r.changed>0),this.resolve(s),r}catch(r){throw this.predictions.refused(s),r}}async resolve(t){if(this.predictions.behind(t).length===0)return;const e=this.client();if(e!==null)try{await e.ping();for(const n of this.predictions.behind(t)){const s=await e.getChunk({lod:0,...n});if(e!==this.client())return;this.predictions.resolved(t,n,s.revision,s)}}catch{e===this.client()&&this.predictions.refused(t)}}}class bx{constructor(t,e){this.ended=t,this.pump=e}waiting=[];running=0;inTurn(t){return new Promise((e,n)=>{const s=this.ended();if(s!==null)throw s;this.waiting.push(()=>{const r=this.ended();if(r!==null){n(r);return}++this.running,t().then(e,n).finally(()=>{--this.running,this.pump()})}),this.pump()})}startNext(){const t=this.waiting.shift();return t?.(),t!==void 0}failAll(){for(const t of this.waiting.splice(0))t()}}const lh=4<<20;function Tx(i,t){const e=new DataView(i.buffer,i.byteOffset,i.byteLength);if(i.length<4||i[0]!==1||i[1]!==0)throw Ut("no column of chunks of version 1");const n=e.getUint16(2,!0),s=2**(31-t),r=[];let o=4,a=-s;for(let l=0;l<n;++l){if(o+12>i.length)throw Ut("a column of chunks that ends within a run");const c=e.getInt32(o,!0),h=e.getUint32(o+4,!0),d=e.getUint32(o+8,!0);if(o+=12,o+d>i.length)throw Ut("a column of chunks that ends within a payload");if(c!==a||h===0)throw Ut(`a column of chunks with row ${c} after row ${a-1}`);r.push({firstY:c,count:h,payload:i.subarray(o,o+d)}),o+=d,a+=h}if(o!==i.length||a!==s)throw Ut("a column of chunks that does not end as it should");return r}function Ax(i,t){const e=new DataView(i.buffer,i.byteOffset,i.byteLength);if(i.length<4||i[0]!==1||i[1]!==t||e.getUint16(2,!0)!==0)throw Ut(`no square of ${t} x ${t} columns of version 1`);const n=[];let s=4;for(let r=0;r<t*t;++r){if(s+4>i.length)throw Ut("a square of columns that ends within one");const o=e.getUint32(s,!0);if(s+=4,s+o>i.length)throw Ut("a square of columns that ends within one");n.push(i.subarray(s,s+o)),s+=o}if(s!==i.length)throw Ut("a square of columns that goes on after its end");return n}const Fn=32,ch=4+10*Fn*Fn;function kr(i,t,e){return{lod:i,x:Math.floor(t/Fn),z:Math.floor(e/Fn)}}function ti({lod:i,x:t,z:e}){return`${i}/${t}/${e}`}class pi{constructor(t){this.revisions=t}static none=new pi(new Map);static read(t){const e=new DataView(t.buffer,t.byteOffset,t.byteLength);if(t.length<4||t[0]!==1||t[1]!==0)throw Ut("no edited columns of version 1");const n=e.getUint16(2,!0);if(t.length!==4+10*n)throw Ut(`${n} edited columns in ${t.length} bytes`);const s=new Map;let r=-1;for(let o=4;o<t.length;o+=10){const a=e.getUint16(o,!0);if(a<=r||a>=Fn*Fn)throw Ut(`an edited column ${a} after ${r}`);s.set(a,e.getBigUint64(o+2,!0)),r=a}return new pi(s)}revision(t,e){return this.revisions.get((e&Fn-1)*Fn+(t&Fn-1))??0n}}function Rx(i,t){let e=0n;for(let n=i.z;n<i.z+i.n;++n)for(let s=i.x;s<i.x+i.n;++s){const r=t.revision(s,n);r>e&&(e=r)}return e}function hh({url:i,revision:t},e){if(t===null)return Cx(i,e);if(!/^[0-9]{1,20}$/.test(t))throw Ut(`a revision ${t.slice(0,40)}`);return BigInt(t)}function Cx(i,t){const e=/@([0-9]{1,20})$/.exec(i);return e===null?t:BigInt(e[1])}class Px{regions=new Map;clear(){this.regions.clear()}follow(t){const e=this.regions;this.regions=new Map,t?.forEachColumn((n,s,r)=>{const o=kr(n,s,r),a=ti(o);this.regions.has(a)||this.regions.set(a,e.get(a)??{region:o,edited:null})})}has(t){return this.regions.has(ti(t))}take(t,e){const n=this.regions.get(ti(t));return n!==void 0&&(n.edited=e),n!==void 0}of(t,e,n){return this.regions.get(ti(kr(t,e,n)))?.edited??null}others(t,e=!1){const n=[];for(const[s,{region:r,edited:o}]of this.regions)!t.has(s)&&!(e&&o!==null)&&n.push(r);return n}}function uh(i,t,e){if(!Array.isArray(i)||i.length!==t||!i.every(n=>typeof n=="number"))throw Ut(`heights whose ${e} are not ${t} numbers`);return i}function Lx(i,t,e,n,s){let r;try{r=JSON.parse(new TextDecoder().decode(i))??{}}catch(c){throw Ut(`heights that are no JSON: ${c.message}`)}const o=Int32Array.from(uh(r.heights,t,"heights"));let a=null;if(e){if(!Array.isArray(r.looks)||r.looks.length!==t)throw Ut(`heights without ${t} looks`);a=Uint8Array.from(r.looks,c=>{const h=s.indexOf(c);if(h<0)throw Ut("a look that the world does not list");return h})}let l=null;return n.length>0&&(l=new Float32Array(t*n.length),n.forEach((c,h)=>{uh(r.fields?.[c],t,c).forEach((d,u)=>{l[u*n.length+h]=d})})),{heightsFx:o,looks:a,values:l}}const Ix=700;async function Dx(i,{looks:t=!1,fields:e=[]},n,s){const r={heightsFx:new Int32Array(i.length),looks:t?new Uint8Array(i.length):null,values:e.length>0?new Float32Array(i.length*e.length):null},o=[...t?["&looks=1"]:[],...e.length>0?[`&fields=${e.map(encodeURIComponent).join(",")}`]:[]].join("");for(let a=0;a<i.length;){let l="",c=a;for(;c<i.length&&l.length<Ix;++c)l+=`${l===""?"":";"}${i[c].x},${i[c].z}`;const h=Lx(await s(`columns=${l}${o}`),c-a,t,e,n());r.heightsFx.set(h.heightsFx,a),h.looks!==null&&r.looks.set(h.looks,a),h.values!==null&&r.values.set(h.values,a*e.length),a=c}return r}const dh=2**17,fh=2**36;function ld({minY:i,maxY:t}){if(!(i>=-fh&&t<=fh&&i<=t&&t-i<=dh))throw Ut(`a world with heights from ${i} to ${t}; worlds have at most ${dh} rows`)}function wn(i){throw Ut(`a world whose ${i} is missing or wrong`)}function He(i,t){const e=i[t];return typeof e=="number"&&Number.isSafeInteger(e)?e:wn(t)}function Hi(i,t){const e=i[t];return typeof e=="string"?e:wn(t)}function Va(i,t){const e=i[t];return Array.isArray(e)?e:wn(t)}function cd(i,t){const e=i[t];return typeof e=="object"&&e!==null?e:wn(t)}function ph(i,t){const e=Hi(i,t);return/^[0-9a-f]{32}$/.test(e)?e:wn(t)}function mh(i,t){return Va(i,t).map(e=>typeof e=="string"?e:wn(t))}function Nx(i){const t=i??{},e=/^#([0-9a-f]{6})$/.exec(Hi(t,"colour")),n=Hi(t,"phase");return(e===null||!["gas","liquid","solid"].includes(n))&&wn("materials"),{id:He(t,"id"),name:Hi(t,"name"),colour:parseInt(e[1],16),phase:n}}function gh(i,t){const e=cd(i,t);return{chunks:He(e,"chunks_per_second"),bytes:He(e,"bytes_per_second"),requests:He(e,"requests_per_second"),burstMs:He(e,"burst_ms")}}function Ux(i){(typeof i!="object"||i===null)&&wn("JSON");const t=i,e=cd(t,"limits"),[n,s,r]=Va(t,"spawn");[n,s,r].every(Number.isSafeInteger)||wn("spawn"),He(t,"chunk_size")!==32&&wn("chunk_size");const o=He(t,"min_y"),a=He(t,"max_y");return ld({minY:o,maxY:a}),{protocol:0,fingerprint:ph(t,"fingerprint"),storeId:ph(t,"store_id"),codec:He(t,"codec"),materials:Va(t,"materials").map(Nx),minY:o,maxY:a,spawn:{x:n,y:s,z:r},limits:{frameBytes:0,requestsInFlight:0,heightsPerRequest:He(e,"heights_per_request"),viewHorizontalRadius:He(e,"view_horizontal_radius"),viewVerticalRadius:He(e,"view_vertical_radius"),viewChunks:He(e,"view_chunks"),windowBytes:0,idleTimeoutMs:0,sessionRates:gh(e,"session"),addressRates:gh(e,"address"),viewHorizon:!0,viewBase:"world_file"in t},server:Hi(t,"server"),looks:mh(t,"looks"),fields:mh(t,"fields"),worldFile:"world_file"in t?Hi(t,"world_file"):""}}const Fx=65538,Ox=4<<20,_h=6,kx=1<<20,Bx=5e3,vh="0".repeat(32),zx=new Set([401,403,408,425,429]);function hs(i,t,e){return`${i}/${t}/${e}`}class Hx extends uu{base;getter;abort=new AbortController;tasks=[];running=new Map;asked=new bx(()=>this.isClosed?this.closedError():null,()=>this.pump());columns=new Map;store=vh;regions=new Px;editsTimer;completeToTell=!1;holdTimer;maker=null;opening=new AbortController;openedFor="";debts=new WeakMap;owedBytes=0;constructor(t,e){super(t),this.base=e.href.replace(/\/$/,""),this.getter={fetch:t.fetch??globalThis.fetch.bind(globalThis),token:t.token},this.attempt()}get worldUrl(){return`${this.base}/v1/${this.world.fingerprint}`}chunksUrl(t,e){return e===0n?`${this.worldUrl}/${this.world.codec}/${t}`:`${this.worldUrl}/${this.store}/${this.world.codec}/${t}@${e}`}regionUrl(t){return`${this.worldUrl}/${this.store}/edits/${ti(t)}`}async get(t,e,n=this.abort.signal,s="GET"){const r=performance.now();++this.stats.requests;const o=await Qd(this.getter,t,e,n,s);return this.stats.latencyMs=performance.now()-r,this.stats.receivedBytes+=o.body.length,o}attempt(){const{signal:t}=this.abort=new AbortController;this.getWorld().then(e=>{t.aborted||this.joined(e)},e=>{t.aborted||this.fail(e)})}async getWorld(){const t=`${this.base}/v1/world`,{body:e}=await this.get(t,Ox).catch(n=>{throw this.world!==null||!(n instanceof io)||zx.has(n.status)||n.status>=500?n:new Bt("refused",`${t} answered ${n.status}: no Talus server has this URL`)});try{return Ux(JSON.parse(new TextDecoder().decode(e)))}catch(n){throw n instanceof Bt?n:Ut(`a world that is no JSON: ${n.message}`)}}worldKnown(t){const{storeId:e}=this.world;(!t||e!==this.store)&&(this.columns.clear(),this.regions.clear()),this.store=e,t||this.stopMaking(),this.options.generate==="always"&&this.beginMaking(),this.lookForEdits(),this.askForEditsLater(),this.pump()}beginMaking(){const t=this.world;if(t.worldFile===""||this.openedFor===t.fingerprint)return;const{fingerprint:e}=t,{signal:n}=this.opening=new AbortController;this.openedFor=e;const s=()=>!this.isClosed&&this.openedFor===e,r=a=>s()&&this.cannotMake(a),o=async a=>{++this.stats.proofs;const{payload:l,revision:c}=await this.asked.inTurn(()=>this.getPayload(a,this.abort.signal,0n));return{key:a,revision:c,hash:au(ol(l)),payload:l,material:null}};il(async()=>{const{MadeTiles:a}=await import("./made_tiles-DE7J4BpS.js");return{MadeTiles:a}},__vite__mapDeps([0,1,2,3,4,5]),import.meta.url).then(({MadeTiles:a})=>a.open(this.options,this.base,t,{compare:o,failed:r},n)).then(a=>s()?this.maker=a:a.end(),r)}cannotMake(t){if(this.maker===null&&this.saidWhy===this.openedFor)return;this.saidWhy=this.openedFor;const e=this.maker!==null;if(this.stopMaking(!1),this.emit("error",new Bt("cannot_generate",`chunks are not made here: ${t.message}`)),!!e){for(const[n,{revision:s}]of this.columns)s===0n&&this.columns.delete(n);this.connected&&this.tracker.view!==null&&this.viewApplied()}}saidWhy="";stopMaking(t=!0){this.opening.abort(),this.maker?.end(),this.maker=null,t&&(this.openedFor="")}async makeTile(t,e,n){const{shape:s}=this.tracker;if(s===null)return;let r;try{r=await e.make(t,s)}catch(o){if(e!==this.maker||n.aborted)return;this.tasks.unshift({tile:t}),this.cannotMake(o);return}if(!n.aborted)for(const{x:o,z:a,rows:l,chunks:c}of r){const h=this.tracker.shape?.rows(t.lod,o,a);if(h?.first!==l.first||h.last!==l.last)continue;const d={rows:l,revision:0n,payloads:null};this.columns.set(hs(t.lod,o,a),d);for(const u of c)this.connected&&this.give(u)&&++this.stats.madeChunks;this.isOld(d,t.lod,o,a)&&this.tasks.unshift({tile:{lod:t.lod,x:o,z:a,n:1}})}}get hasEdits(){return this.store!==vh}askForEditsLater(){const t=this.options.editsIntervalMs??Bx;!this.hasEdits||!(t>0)||t===1/0||(this.editsTimer??=setTimeout(()=>{this.editsTimer=void 0,this.lookForEdits(),this.askForEditsLater(),this.pump()},t))}lookForEdits(){const t=new Set;for(const e of[...this.tasks,...this.running.keys()])"region"in e&&t.add(ti(e.region));this.tasks.unshift(...this.regions.others(t).map(e=>({region:e})))}editedOf(t,e,n){return this.hasEdits?this.regions.of(t,e,n):pi.none}isOld({revision:t},e,n,s){return(this.editedOf(e,n,s)?.revision(n,s)??0n)>t}takeRegion(t,e){if(!this.regions.take(t,e))return;const n=[];for(const[r,o]of this.columns){const[a,l,c]=r.split("/").map(Number),h=kr(a,l,c);a!==t.lod||h.x!==t.x||h.z!==t.z||this.isOld(o,a,l,c)&&n.push({tile:{lod:a,x:l,z:c,n:1}})}const s=new Set([...this.tasks,...this.running.keys()].map(r=>"tile"in r?so(r.tile):""));this.tasks.unshift(...n.filter(r=>"tile"in r&&!s.has(so(r.tile))))}fail(t){this.halt(),this.lost(t)}halt(){this.abort.abort(),this.tasks=[];for(const t of this.running.values())t.abort();this.running.clear(),clearTimeout(this.holdTimer),this.holdTimer=void 0,clearTimeout(this.editsTimer),this.editsTimer=void 0,this.completeToTell=!1}stopped(){this.halt(),this.stopMaking(),this.asked.failAll()}viewApplied(){const{view:t,shape:e}=this.tracker;this.completeToTell=t!==null;const n=this.tasks.filter(o=>"region"in o);this.tasks=[],this.regions.follow(this.hasEdits?e:null);for(const[o,{rows:a}]of this.columns){const[l,c,h]=o.split("/").map(Number),d=e?.rows(l,c,h);(d?.first!==a.first||d.last!==a.last)&&this.columns.delete(o)}const s=new Set,r=new Set;for(const[o,a]of this.running){if("region"in o&&(this.regions.has(o.region)?r.add(ti(o.region)):(this.running.delete(o),a.abort())),!("tile"in o))continue;let l=!1;ic(o.tile,(c,h)=>{e?.hasColumn(o.tile.lod,c,h)&&(l=!0,s.add(hs(o.tile.lod,c,h)))}),l||(this.running.delete(o),a.abort())}t!==null&&e!==null&&(this.tasks=af(t,e,(o,a,l)=>{const c=this.columns.get(hs(o,a,l));return c!==void 0&&!this.isOld(c,o,a,l)?!1:!s.has(hs(o,a,l))}).map(o=>({tile:o})));for(const o of n)!("region"in o)||!this.regions.has(o.region)||(r.add(ti(o.region)),this.tasks.unshift(o));this.tasks.unshift(...this.regions.others(r,!0).map(o=>({region:o}))),this.pump()}pump(){if(!this.connected)return;const t=Math.max(1,Math.min(_h,this.options.requestsAtOnce??_h)),e=()=>this.asked.running+this.running.size>=t;for(;!e()&&this.asked.startNext(););const n=this.options.windowBytes??kx;for(;!e()&&this.holdTimer===void 0&&this.owedBytes<n;){const s=this.tasks.findIndex(a=>this.mayStart(a));if(s<0)break;const r=this.tasks.splice(s,1)[0],o=new AbortController;this.running.set(r,o),this.run(r,o)}this.completeToTell&&this.tasks.length===0&&this.running.size===0&&(this.completeToTell=!1,this.tellComplete(),this.connected&&this.options.generate==="auto"&&this.beginMaking())}mayStart(t){if("region"in t)return!0;const{lod:e,x:n,z:s}="tile"in t?t.tile:t.key;return this.editedOf(e,n,s)!==null}async run(t,e){try{if("region"in t){const{body:n}=await this.get(this.regionUrl(t.region),ch,e.signal);if(e.signal.aborted)return;this.backoff.reset(),this.takeRegion(t.region,pi.read(n))}else if("tile"in t){const{tile:n}=t,s=this.editedOf(n.lod,n.x,n.z),r=Rx(n,s);if(this.maker!==null&&(r===0n||n.n>1)){r===0n?await this.makeTile(n,this.maker,e.signal):this.tasks.unshift(...sc(n).map(a=>({tile:a}))),this.running.delete(t),this.pump();return}const o=await this.get(this.chunksUrl(so(n),r),lh,e.signal);if(e.signal.aborted)return;this.backoff.reset(),this.stats.chunkBytes+=o.body.length,this.takeTile(n,o.body,s,hh(o,r))}else{const{key:n}=t,{payload:s,revision:r}=await this.getPayload(n,e.signal);if(e.signal.aborted)return;this.backoff.reset(),this.stats.chunkBytes+=s.length,this.give({key:n,revision:r,hash:null,payload:s,material:xs(s)})}}catch(n){if(e.signal.aborted)return;if(!(n instanceof Bt))throw n;this.running.delete(t),this.failTask(t,n)}this.running.delete(t),this.pump()}async getPayload(t,e,n=this.editedOf(t.lod,t.x,t.z)?.revision(t.x,t.z)??0n){const s=await this.get(this.chunksUrl(Jn(t),n),Fx,e);return{payload:s.body.slice(),revision:hh(s,n)}}takeTile(t,e,n,s){const r=t.n===1?[e]:Ax(e,t.n);let o=0;ic(t,(a,l)=>{const c=r[o++],h=this.tracker.shape?.rows(t.lod,a,l);if(h===void 0||h.last<h.first||!this.connected)return;const d=Tx(c,t.lod),u=hs(t.lod,a,l),f=t.n===1?s:n.revision(a,l),v=this.columns.get(u);if(v!==void 0&&v.revision>f)return;const S=f>0n?new Map:null,m={rows:h,revision:f,payloads:S};this.columns.set(u,m),this.isOld(m,t.lod,a,l)&&this.tasks.unshift({tile:{lod:t.lod,x:a,z:l,n:1}});for(const p of d){const M=Math.min(h.last,p.firstY+p.count-1),A=Math.max(h.first,p.firstY);if(A>M)continue;const E=xs(p.payload),R=S===null?p.payload:p.payload.slice();for(let b=A;b<=M&&this.connected;++b)S?.set(b,R),!Gx(v?.payloads?.get(b),p.payload)&&this.give({key:{lod:t.lod,x:a,y:b,z:l},revision:f,hash:null,payload:new Uint8Array(p.payload),material:E})}})}give(t){return this.deliver(t)?(this.options.manualCredit&&(this.debts.set(t,t.payload.length),this.owedBytes+=t.payload.length),!0):!1}taken(t){const e=this.debts.get(t);e!==void 0&&(this.debts.delete(t),this.owedBytes-=e,this.pump())}failTask(t,e){if(e.kind==="overloaded"){this.tasks.unshift(t);const n=this.backoff.next(e.retryAfterMs);if(n===null){this.fail(e);return}this.holdTimer??=setTimeout(()=>{this.holdTimer=void 0,this.pump()},n);return}if(e instanceof io&&e.status===404){this.fail(new Bt("disconnected",e.message));return}if(e instanceof io&&e.code==="too_large"&&"tile"in t){this.tasks.unshift(...this.smaller(t.tile));return}if(e.kind==="out_of_range"||e.kind==="broken_protocol"){"region"in t&&this.takeRegion(t.region,pi.none),this.emit("error",e);return}this.fail(e)}smaller(t){if(t.n>1)return sc(t).map(a=>({tile:a}));const{lod:e,x:n,z:s}=t,r=this.tracker.shape?.rows(e,n,s),o=[];if(r===void 0)return o;for(let a=r.first;a<=r.last;++a)o.push({key:{lod:e,x:n,y:a,z:s}});return o}async getChunk(t){lu(t);const{payload:e,revision:n}=await this.asked.inTurn(async()=>{if(!this.hasEdits)return this.getPayload(t,this.abort.signal);const s=kr(t.lod,t.x,t.z),{body:r}=await this.get(this.regionUrl(s),ch),o=pi.read(r).revision(t.x,t.z);return this.getPayload(t,this.abort.signal,o)});return{key:{...t},revision:n,hash:null,payload:e,material:xs(e)}}async getPlaces(t,e={}){cu(t);const n=async s=>(await this.get(`${this.base}/v1/heights?${s}`,lh)).body;return Dx(t,e,()=>this.world.looks,s=>this.asked.inTurn(()=>n(s)))}async edit(){throw new Bt("refused","edits need a stream: connect by ws:, wss:, tcp: or tls: instead of http:")}editLimits(){return this.edit()}async ping(){if(!this.connected)throw new Bt("disconnected","ping: the client is not connected");const t=performance.now();return await this.get(`${this.base}/v1/world`,0,this.abort.signal,"HEAD"),this.stats.latencyMs=performance.now()-t}}function Gx(i,t){return i!==void 0&&i.length===t.length&&i.every((e,n)=>e===t[n])}const br=2147483648,Wa="0".repeat(32),xh=(i,t)=>i.sequence<t.sequence?-1:1;class Vx{editor=Wa;seenRevision=0n;state="none";lastSequence=0n;unanswered=1;waiting=[];again=[];inFlight=new Map;lastId=0;add(t){this.waiting.push(t)}get isEmpty(){return this.waiting.length===0&&this.again.length===0&&this.inFlight.size===0}get attachState(){return this.state}attachSent(){this.state="sent"}attachRefused(){this.state="none"}expired(){this.state==="attached"&&(this.state="none")}saw(t){t>this.seenRevision&&(this.seenRevision=t)}attached(t,e,n,s,r){const o=e?[]:this.again;return e||(this.again=[],this.lastSequence=0n),this.state="attached",this.editor=t,n>this.lastSequence&&(this.lastSequence=n),this.unanswered=Math.max(1,r),this.saw(s),o}forgetEditor(){this.connectionEnded();const t=this.again;return this.again=[],this.editor=Wa,this.lastSequence=this.seenRevision=0n,t}get hasNext(){return this.state==="attached"&&this.inFlight.size<this.unanswered&&(this.again.length>0||this.waiting.length>0)}sendNext(){let t=this.again.shift();t===void 0&&(t=this.waiting.shift(),t.sequence=++this.lastSequence);do this.lastId=(this.lastId+1)%br;while(this.inFlight.has(br+this.lastId));const e=br+this.lastId;return this.inFlight.set(e,t),{id:e,open:t}}has(t){return this.inFlight.has(t)}take(t){const e=this.inFlight.get(t);return this.inFlight.delete(t),e}putBack(t){const e=this.take(t);e.sentBefore=!0,this.again=[...this.again,e].sort(xh)}sendAsNew(t){const e=this.take(t);e.sentBefore=!1;const n=this.waiting.findIndex(({sequence:s})=>s===0n||s>e.sequence);this.waiting.splice(n<0?this.waiting.length:n,0,e)}connectionEnded(){this.state="none";for(const t of this.inFlight.values())t.sentBefore=!0;this.again=[...this.again,...this.inFlight.values()].sort(xh),this.inFlight.clear()}takeAll(){this.connectionEnded();const t={sent:this.again,unsent:this.waiting};return this.again=[],this.waiting=[],t}}const Fo=2,Sn=4,On=4,Wx=4,Zn=new Int32Array(2),Sh=new Float32Array(Zn.buffer),Mh=new Float64Array(Zn.buffer),or=new Uint16Array(new Uint8Array([1,0]).buffer)[0]===1;var Xa;(function(i){i[i.UTF8_BYTES=1]="UTF8_BYTES",i[i.UTF16_STRING=2]="UTF16_STRING"})(Xa||(Xa={}));class Br{constructor(t){this.bytes_=t,this.position_=0,this.text_decoder_=new TextDecoder}static allocate(t){return new Br(new Uint8Array(t))}clear(){this.position_=0}bytes(){return this.bytes_}position(){return this.position_}setPosition(t){this.position_=t}capacity(){return this.bytes_.length}readInt8(t){return this.readUint8(t)<<24>>24}readUint8(t){return this.bytes_[t]}readInt16(t){return this.readUint16(t)<<16>>16}readUint16(t){return this.bytes_[t]|this.bytes_[t+1]<<8}readInt32(t){return this.bytes_[t]|this.bytes_[t+1]<<8|this.bytes_[t+2]<<16|this.bytes_[t+3]<<24}readUint32(t){return this.readInt32(t)>>>0}readInt64(t){return BigInt.asIntN(64,BigInt(this.readUint32(t))+(BigInt(this.readUint32(t+4))<<BigInt(32)))}readUint64(t){return BigInt.asUintN(64,BigInt(this.readUint32(t))+(BigInt(this.readUint32(t+4))<<BigInt(32)))}readFloat32(t){return Zn[0]=this.readInt32(t),Sh[0]}readFloat64(t){return Zn[or?0:1]=this.readInt32(t),Zn[or?1:0]=this.readInt32(t+4),Mh[0]}writeInt8(t,e){this.bytes_[t]=e}writeUint8(t,e){this.bytes_[t]=e}writeInt16(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8}writeUint16(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8}writeInt32(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8,this.bytes_[t+2]=e>>16,this.bytes_[t+3]=e>>24}writeUint32(t,e){this.bytes_[t]=e,this.bytes_[t+1]=e>>8,this.bytes_[t+2]=e>>16,this.bytes_[t+3]=e>>24}writeInt64(t,e){this.writeInt32(t,Number(BigInt.asIntN(32,e))),this.writeInt32(t+4,Number(BigInt.asIntN(32,e>>BigInt(32))))}writeUint64(t,e){this.writeUint32(t,Number(BigInt.asUintN(32,e))),this.writeUint32(t+4,Number(BigInt.asUintN(32,e>>BigInt(32))))}writeFloat32(t,e){Sh[0]=e,this.writeInt32(t,Zn[0])}writeFloat64(t,e){Mh[0]=e,this.writeInt32(t,Zn[or?0:1]),this.writeInt32(t+4,Zn[or?1:0])}getBufferIdentifier(){if(this.bytes_.length<this.position_+Sn+On)throw new Error("FlatBuffers: ByteBuffer is too short to contain an identifier.");let t="";for(let e=0;e<On;e++)t+=String.fromCharCode(this.readInt8(this.position_+Sn+e));return t}__offset(t,e){const n=t-this.readInt32(t);return e<this.readInt16(n)?this.readInt16(n+e):0}__union(t,e){return t.bb_pos=e+this.readInt32(e),t.bb=this,t}__string(t,e){t+=this.readInt32(t);const n=this.readInt32(t);t+=Sn;const s=this.bytes_.subarray(t,t+n);return e===Xa.UTF8_BYTES?s:this.text_decoder_.decode(s)}__union_with_string(t,e){return typeof t=="string"?this.__string(e):this.__union(t,e)}__indirect(t){return t+this.readInt32(t)}__vector(t){return t+this.readInt32(t)+Sn}__vector_len(t){return this.readInt32(t+this.readInt32(t))}__has_identifier(t){if(t.length!=On)throw new Error("FlatBuffers: file identifier must be length "+On);for(let e=0;e<On;e++)if(t.charCodeAt(e)!=this.readInt8(this.position()+Sn+e))return!1;return!0}createScalarList(t,e){const n=[];for(let s=0;s<e;++s){const r=t(s);r!==null&&n.push(r)}return n}createObjList(t,e){const n=[];for(let s=0;s<e;++s){const r=t(s);r!==null&&n.push(r.unpack())}return n}}let Xx=class hd{constructor(t){this.minalign=1,this.vtable=null,this.vtable_in_use=0,this.isNested=!1,this.object_start=0,this.vtables=[],this.vector_num_elems=0,this.force_defaults=!1,this.string_maps=null,this.text_encoder=new TextEncoder;let e;t?e=t:e=1024,this.bb=Br.allocate(e),this.space=e}clear(){this.bb.clear(),this.space=this.bb.capacity(),this.minalign=1,this.vtable=null,this.vtable_in_use=0,this.isNested=!1,this.object_start=0,this.vtables=[],this.vector_num_elems=0,this.force_defaults=!1,this.string_maps=null}forceDefaults(t){this.force_defaults=t}dataBuffer(){return this.bb}asUint8Array(){return this.bb.bytes().subarray(this.bb.position(),this.bb.position()+this.offset())}prep(t,e){t>this.minalign&&(this.minalign=t);const n=~(this.bb.capacity()-this.space+e)+1&t-1;for(;this.space<n+t+e;){const s=this.bb.capacity();this.bb=hd.growByteBuffer(this.bb),this.space+=this.bb.capacity()-s}this.pad(n)}pad(t){for(let e=0;e<t;e++)this.bb.writeInt8(--this.space,0)}writeInt8(t){this.bb.writeInt8(this.space-=1,t)}writeInt16(t){this.bb.writeInt16(this.space-=2,t)}writeInt32(t){this.bb.writeInt32(this.space-=4,t)}writeInt64(t){this.bb.writeInt64(this.space-=8,t)}writeFloat32(t){this.bb.writeFloat32(this.space-=4,t)}writeFloat64(t){this.bb.writeFloat64(this.space-=8,t)}addInt8(t){this.prep(1,0),this.writeInt8(t)}addInt16(t){this.prep(2,0),this.writeInt16(t)}addInt32(t){this.prep(4,0),this.writeInt32(t)}addInt64(t){this.prep(8,0),this.writeInt64(t)}addFloat32(t){this.prep(4,0),this.writeFloat32(t)}addFloat64(t){this.prep(8,0),this.writeFloat64(t)}addFieldInt8(t,e,n){(this.force_defaults||e!=n)&&(this.addInt8(e),this.slot(t))}addFieldInt16(t,e,n){(this.force_defaults||e!=n)&&(this.addInt16(e),this.slot(t))}addFieldInt32(t,e,n){(this.force_defaults||e!=n)&&(this.addInt32(e),this.slot(t))}addFieldInt64(t,e,n){(this.force_defaults||e!==n)&&(this.addInt64(e),this.slot(t))}addFieldFloat32(t,e,n){(this.force_defaults||e!=n)&&(this.addFloat32(e),this.slot(t))}addFieldFloat64(t,e,n){(this.force_defaults||e!=n)&&(this.addFloat64(e),this.slot(t))}addFieldOffset(t,e,n){(this.force_defaults||e!=n)&&(this.addOffset(e),this.slot(t))}addFieldStruct(t,e,n){e!=n&&(this.nested(e),this.slot(t))}nested(t){if(t!=this.offset())throw new TypeError("FlatBuffers: struct must be serialized inline.")}notNested(){if(this.isNested)throw new TypeError("FlatBuffers: object serialization must not be nested.")}slot(t){this.vtable!==null&&(this.vtable[t]=this.offset())}offset(){return this.bb.capacity()-this.space}static growByteBuffer(t){const e=t.capacity();if(e&3221225472)throw new Error("FlatBuffers: cannot grow buffer beyond 2 gigabytes.");const n=e<<1,s=Br.allocate(n);return s.setPosition(n-e),s.bytes().set(t.bytes(),n-e),s}addOffset(t){this.prep(Sn,0),this.writeInt32(this.offset()-t+Sn)}startObject(t){this.notNested(),this.vtable==null&&(this.vtable=[]),this.vtable_in_use=t;for(let e=0;e<t;e++)this.vtable[e]=0;this.isNested=!0,this.object_start=this.offset()}endObject(){if(this.vtable==null||!this.isNested)throw new Error("FlatBuffers: endObject called without startObject");this.addInt32(0);const t=this.offset();let e=this.vtable_in_use-1;for(;e>=0&&this.vtable[e]==0;e--);const n=e+1;for(;e>=0;e--)this.addInt16(this.vtable[e]!=0?t-this.vtable[e]:0);const s=2;this.addInt16(t-this.object_start);const r=(n+s)*Fo;this.addInt16(r);let o=0;const a=this.space;t:for(e=0;e<this.vtables.length;e++){const l=this.bb.capacity()-this.vtables[e];if(r==this.bb.readInt16(l)){for(let c=Fo;c<r;c+=Fo)if(this.bb.readInt16(a+c)!=this.bb.readInt16(l+c))continue t;o=this.vtables[e];break}}return o?(this.space=this.bb.capacity()-t,this.bb.writeInt32(this.space,o-t)):(this.vtables.push(this.offset()),this.bb.writeInt32(this.bb.capacity()-t,this.offset()-t)),this.isNested=!1,t}finish(t,e,n){const s=n?Wx:0;if(e){const r=e;if(this.prep(this.minalign,Sn+On+s),r.length!=On)throw new TypeError("FlatBuffers: file identifier must be length "+On);for(let o=On-1;o>=0;o--)this.writeInt8(r.charCodeAt(o))}this.prep(this.minalign,Sn+s),this.addOffset(t),s&&this.addInt32(this.bb.capacity()-this.space),this.bb.setPosition(this.space)}finishSizePrefixed(t,e){this.finish(t,e,!0)}requiredField(t,e){const n=this.bb.capacity()-t,s=n-this.bb.readInt32(n);if(!(e<this.bb.readInt16(s)&&this.bb.readInt16(s+e)!=0))throw new TypeError("FlatBuffers: field "+e+" must be set")}startVector(t,e,n){this.notNested(),this.vector_num_elems=e,this.prep(Sn,t*e),this.prep(n,t*e)}endVector(){return this.writeInt32(this.vector_num_elems),this.offset()}createSharedString(t){if(!t)return 0;if(this.string_maps||(this.string_maps=new Map),this.string_maps.has(t))return this.string_maps.get(t);const e=this.createString(t);return this.string_maps.set(t,e),e}createString(t){if(t==null)return 0;let e;return t instanceof Uint8Array?e=t:e=this.text_encoder.encode(t),this.addInt8(0),this.startVector(1,e.length,1),this.bb.setPosition(this.space-=e.length),this.bb.bytes().set(e,this.space),this.endVector()}createByteVector(t){return t==null?0:(this.startVector(1,t.length,1),this.bb.setPosition(this.space-=t.length),this.bb.bytes().set(t,this.space),this.endVector())}createObjectOffset(t){return t===null?0:typeof t=="string"?this.createString(t):t.pack(this)}createObjectOffsetList(t){const e=[];for(let n=0;n<t.length;++n){const s=t[n];if(s!==null)e.push(this.createObjectOffset(s));else throw new TypeError("FlatBuffers: Argument for createObjectOffsetList cannot contain null.")}return e}createStructOffsetList(t,e){return e(this,t.length),this.createObjectOffsetList(t.slice().reverse()),this.endVector()}};const ud=40,dd=32,fd=16,pd=128;function ri(i,t){const e=new Xx(256),n=t(e);return e.startObject(2),e.addFieldOffset(1,n,0),e.addFieldInt8(0,i,0),e.finishSizePrefixed(e.endObject()),e.asUint8Array()}function wi(i,t,e,n,s){i.startVector(e,t.length,n);for(let r=t.length-1;r>=0;--r)i.prep(n,e),s(t[r]);return i.endVector()}function Tl(i,t){i.writeInt64(BigInt(`0x${t.slice(0,16)}`)),i.writeInt64(BigInt(`0x${t.slice(16)}`))}function md(i,t){i.pad(3),i.writeInt8(t.lod),i.writeInt32(t.z),i.writeInt32(t.y),i.writeInt32(t.x)}function qx(i){return ri(1,t=>{t.startVector(1,i.codecs.length,1);for(let r=i.codecs.length-1;r>=0;--r)t.addInt8(i.codecs[r]);const e=t.endVector(),n=t.createString(i.token),s=t.createString(i.client);return t.startObject(6),t.addFieldInt64(5,BigInt(i.windowBytes),0n),t.addFieldOffset(4,s,0),t.addFieldOffset(3,n,0),t.addFieldOffset(2,e,0),t.addFieldInt16(1,i.protocolMax,0),t.addFieldInt16(0,i.protocolMin,0),t.endObject()})}function wh(i,t,e,n=!1){return ri(2,s=>{const r=wi(s,e,dd,8,a=>{Tl(s,a.hash),md(s,a.key)}),o=wi(s,i.rings??[],4,2,a=>{s.writeInt16(a.radius),s.pad(1),s.writeInt8(a.lod)});return s.startObject(9),s.prep(8,24),s.writeInt64(BigInt(i.centre.z)),s.writeInt64(BigInt(i.centre.y)),s.writeInt64(BigInt(i.centre.x)),s.addFieldStruct(0,s.offset(),0),i.direction!==void 0&&(s.prep(4,12),s.writeFloat32(i.direction.z),s.writeFloat32(i.direction.y),s.writeFloat32(i.direction.x),s.addFieldStruct(1,s.offset(),0)),s.addFieldInt16(2,i.horizontalRadius,0),s.addFieldInt16(3,i.verticalRadius,0),s.addFieldOffset(4,o,0),s.addFieldOffset(5,r,0),s.addFieldInt32(6,t,0),s.addFieldInt8(7,i.horizon?1:0,0),s.addFieldInt8(8,n?1:0,0),s.endObject()})}function $x(i){return ri(3,t=>{const e=wi(t,i,ud,8,n=>{Tl(t,n.known??"0".repeat(32)),t.pad(3),t.writeInt8(n.known===null?0:1),md(t,n.key),t.writeInt32(n.id)});return t.startObject(1),t.addFieldOffset(0,e,0),t.endObject()})}function Yx(i,t,e,n){return ri(5,s=>{const r=wi(s,t,fd,8,a=>{s.writeInt64(BigInt(a.z)),s.writeInt64(BigInt(a.x))}),o=wi(s,n,1,1,a=>s.writeInt8(a));return s.startObject(4),s.addFieldOffset(3,o,0),s.addFieldOffset(1,r,0),s.addFieldInt32(0,i,0),s.addFieldInt8(2,e?1:0,0),s.endObject()})}function Kx(i){return ri(6,t=>(t.startObject(1),t.addFieldInt64(0,BigInt(i),0n),t.endObject()))}function Zx(i){return ri(8,t=>(t.startObject(1),t.addFieldInt64(0,BigInt(i),0n),t.endObject()))}const Al=24;function zr(i,{x:t,y:e,z:n}){i.writeInt64(BigInt(n)),i.writeInt64(BigInt(e)),i.writeInt64(BigInt(t))}function yh(i,t){return t.length===0?0:wi(i,t,Al+8,8,({voxel:e,material:n})=>{i.pad(6),i.writeInt16(n),zr(i,e)})}function Jx(i,t){return t.length===0?0:wi(i,t,2*Al+8,8,e=>{i.pad(3),i.writeInt8(e.flags),i.writeInt16(e.only),i.writeInt16(e.material),zr(i,e.last),zr(i,e.first)})}function Qx(i,t){if(t===null)return 0;const e=i.createByteVector(t.payload);return i.startObject(3),i.prep(8,Al),zr(i,t.origin),i.addFieldStruct(0,i.offset(),0),i.addFieldOffset(1,e,0),i.addFieldInt8(2,t.withAir?1:0,0),i.endObject()}function jx(i,t,e){return ri(7,n=>{const s=yh(n,e.writes),r=yh(n,e.guards),o=Jx(n,e.fills),a=Qx(n,e.paste),l=e.subject===""?0:n.createString(e.subject);return n.startObject(7),n.addFieldInt64(2,t,0n),n.addFieldInt32(0,i,0),n.addFieldOffset(1,s,0),n.addFieldOffset(3,r,0),n.addFieldOffset(4,o,0),n.addFieldOffset(5,a,0),n.addFieldOffset(6,l,0),n.endObject()})}function tS(i,t){return ri(20,e=>(e.startObject(2),e.prep(8,16),Tl(e,i),e.addFieldStruct(0,e.offset(),0),e.addFieldInt64(1,t,0n),e.endObject()))}function Rl(i){return new Bt("out_of_range",`edit: ${i}`)}function Hr(i,t){const{x:e,y:n,z:s}=i;if([e,n,s].every(Number.isSafeInteger))return{x:e,y:n,z:s};throw Rl(`${t} (${e}, ${n}, ${s}) must be of whole numbers`)}function qa(i,t){if(Number.isInteger(i)&&i>=0&&i<=65535)return i;throw Rl(`material ${i} of ${t}; materials are 0 to 65535`)}function Eh(i=[],t){return i.map(e=>({voxel:Hr(e.voxel,t),material:qa(e.material,t)}))}function eS({first:i,last:t,material:e,only:n}){const s={first:Hr(i,"fill.first"),last:Hr(t,"fill.last")};if(i.x>t.x||i.y>t.y||i.z>t.z)throw Rl("fill.first must be the lowest corner, fill.last the highest");return{...s,material:e==="generated"?0:qa(e,"a fill"),only:n===void 0?0:qa(n,"fill.only"),flags:(n===void 0?1:0)|(e==="generated"?2:0)}}function nS(i){const{paste:t}=i;return{guards:Eh(i.guards,"a guard"),writes:Eh(i.writes,"a write"),fills:(i.fills??[]).map(eS),paste:t===void 0?null:{origin:Hr(t.origin,"paste.origin"),payload:rl(t.voxels),withAir:t.withAir??!1},subject:i.subject??""}}const iS="0".repeat(32);function Oo(i){return i.storeId===iS?new Bt("refused","this server stores no edits"):null}const ar=()=>new Bt("outcome_unknown","the server knows nothing of this edit any more: it may have happened, or not");function lr(i,t){for(const{reject:e}of i)e(t)}class sS{constructor(t){this.wake=t}open=new Vx;askers=[];limits=null;storeId=null;edit(t,e){return new Promise((n,s)=>{const r=e===null?null:Oo(e);if(r!==null)throw r;this.open.add({edit:jd("edit",()=>nS(t)),sequence:0n,sentBefore:!1,resolve:n,reject:s}),this.wake()})}askLimits(t){return new Promise((e,n)=>{const s=t===null?null:Oo(t);if(s!==null)throw s;if(this.limits!==null)return e(this.limits);this.askers.push({resolve:e,reject:n}),this.wake()})}saw(t){this.open.saw(t)}joined(t,e){const n=this.storeId===null||this.storeId===t.storeId;this.storeId=t.storeId;const s=Oo(t);(!n||s!==null)&&lr(this.open.forgetEditor(),ar()),s!==null?this.failAll(s):!e&&!n&&this.failAll(new Bt("not_applied","the server has another world now"))}connectionEnded(){this.open.connectionEnded(),this.limits=null}failAll(t){const{sent:e,unsent:n}=this.open.takeAll();lr(e,t.kind==="closed"?t:ar()),lr(n,t);for(const{reject:s}of this.askers.splice(0))s(t)}get hasNext(){return this.mustAttach||this.open.hasNext}get mustAttach(){return this.open.attachState==="none"&&(!this.open.isEmpty||this.askers.length>0)}next(t){if(this.mustAttach)return this.open.attachSent(),tS(this.open.editor,this.open.seenRevision);const{id:e,open:n}=this.open.sendNext(),s=jx(e,n.sequence,n.edit);if(s.length<=t)return s;const r=`an edit of ${s.length} bytes is more than this server takes in a frame (${t}); divide it`;return this.open.take(e).reject(new Bt("out_of_range",r)),null}handleAttached(t){if(this.open.attachState!=="sent"||t.editor===Wa)throw Ut("an Attached that no Attach asked for, or without an editor");const{editor:e,known:n,lastSequence:s,revision:r,limits:o}=t;lr(this.open.attached(e,n,s,r,o.unanswered),ar()),this.limits=o;for(const{resolve:a}of this.askers.splice(0))a(o)}handleResult({id:t,revision:e,changed:n}){if(!this.open.has(t))throw Ut(`an EditResult for request ${t}, which is no edit in flight`);this.open.saw(e),this.open.take(t).resolve({revision:e,changed:n})}editRefused(t,e,n){const s=t.requestId;if(!this.open.has(s))throw Ut(`an Error about request ${s}, which is no edit in flight`);if(n)this.open.putBack(s);else if(t.code==="expired")this.open.putBack(s),this.open.expired();else if(t.code==="not_applied")this.open.sendAsNew(s);else{const r=this.open.take(s);r.reject(r.sentBefore&&t.code!=="conflict"?ar():e)}}attachRefused(t,e){this.open.attachState==="sent"&&(this.open.attachRefused(),e||this.failAll(t))}}function gd(i){const t=Array.isArray(i)?i:[i];if(t.length===0)throw new Bt("unreachable","url: there is none");for(const e of t)if(typeof e!="string")throw new Bt("unreachable",`url: a string or a list of strings is needed, not ${e===null?"null":typeof e}`);return t}function Cl(i){return i.replace(/[?#].*$/s,"").replace(/^([^/]*:?\/\/)?.*@/s,"$1")}function Pl(i){const t=n=>new Bt("unreachable",`url ${Cl(i)}: ${n}`);let e;try{const n=globalThis.location;e=new URL(i,n?.host?n.origin+n.pathname:void 0)}catch{}if(e===void 0||e.hostname==="")throw t("it is not one of a server, as ws://127.0.0.1:4781 is");if(e.username!==""||e.password!=="")throw t("user and password in it are never sent; give the token as the option token");return e.search=e.hash="",e}const Gi=4,bh=12,Th=262144;class Ah{held=new Uint8Array(0);count=0;push(t,e){let n=t;for(;n.length>0;){if(this.count===0){const o=ko(n);if(o!==null&&o<=n.length){e(n.subarray(0,o)),n=n.subarray(o);continue}}const s=this.count<Gi?Gi:ko(this.held),r=Math.min(s-this.count,n.length);if(this.keep(n.subarray(0,r)),n=n.subarray(r),this.count>=Gi&&this.count===ko(this.held)){const o=this.held.subarray(0,this.count);this.count=0,e(o)}}}keep(t){if(this.count+t.length>this.held.length){const e=new Uint8Array(Math.max(1024,2*this.held.length,this.count+t.length));e.set(this.held.subarray(0,this.count)),this.held=e}this.held.set(t,this.count),this.count+=t.length}}const rS=1347703880+Gi;function ko(i){if(i.length<Gi)return null;const t=(i[0]|i[1]<<8|i[2]<<16)+i[3]*16777216+Gi;if(t===rS)throw Ut("HTTP, not frames: connect by http:// or ws:// there");if(t<bh||t>Th)throw Ut(`a frame of ${t} bytes; frames have ${bh} to ${Th}`);return t}const oS=["none","version","malformed","unexpected","too_large","too_many_requests","out_of_range","cancelled","unsupported","unauthorized","overloaded","timeout","duplicate_id","internal","forbidden","conflict","expired","not_applied"],aS=["unspecified","connection","request","repeated_request","view","view_chunk","ping","attach"],lS=["gas","liquid","solid"],cS={9:mS,10:i=>({kind:"chunk",id:i.u32(0),key:cr(i,1),revision:i.u64(2),hash:ys(i,3),codec:i.u8(4),payload:i.bytesOf(5)}),11:i=>({kind:"unchanged",id:i.u32(0),key:cr(i,1),revision:i.u64(2),hash:ys(i,3)}),12:gS,13:_S,14:i=>({kind:"error",code:oS[i.u16(0)]??"unknown",text:i.text(1),requestId:i.u32(2),retryAfterMs:i.u32(3),about:aS[i.u8(4)]??"unspecified",repeatedId:i.u32(5),viewNumber:i.u32(6),chunk:i.struct(7,16)===0?null:cr(i,7)}),15:i=>({kind:"edit_result",id:i.u32(0),revision:i.u64(1),changed:i.u32(2)}),16:i=>({kind:"edit_broadcast",key:cr(i,0),revision:i.u64(1),previousRevision:i.u64(2),runs:i.bytesOf(4)}),17:i=>({kind:"pong",nonce:i.u64(0)}),18:i=>({kind:"go_away",reason:i.text(0),retryAfterMs:i.u32(1)}),19:i=>({kind:"view_complete",number:i.u32(0)}),21:i=>({kind:"attached",editor:ys(i,0),epoch:i.u64(1),lastSequence:i.u64(2),known:i.bool(3),revision:i.u64(4),limits:fS(i.table(5))})};function hS(i){const t=new Zd(i).root(),e=t.u8(0),n=cS[e],s=t.table(1);if(n===void 0||s===null)throw Ut(`a message of kind ${e}, which no server sends`);return n(s)}function cr(i,t){const e=i.struct(t,16);if(e===0)throw Ut("a chunk without a key");return{lod:i.data.getUint8(e+12),x:i.data.getInt32(e,!0),y:i.data.getInt32(e+4,!0),z:i.data.getInt32(e+8,!0)}}function Rh(i,t){const e=n=>n.toString(16).padStart(8,"0");return e(i.getUint32(t+4,!0))+e(i.getUint32(t,!0))}function ys(i,t){const e=i.struct(t,16);return e===0?"0".repeat(32):Rh(i.data,e+8)+Rh(i.data,e)}function $a(i,t){const e=Number(i);if(!Number.isSafeInteger(e))throw Ut(`${t} ${i}, which is beyond any world`);return e}function uS(i,t,e){const n=i.struct(t,24);if(n===0)return{x:0,y:0,z:0};const s=r=>$a(i.data.getBigInt64(n+8*r,!0),e);return{x:s(0),y:s(1),z:s(2)}}function Ch(i){return i===null?null:{chunks:Number(i.u64(0)),bytes:Number(i.u64(1)),requests:Number(i.u64(2)),burstMs:i.u32(3)}}function dS(i){if(i===null)throw Ut("a Welcome without limits");return{frameBytes:i.u32(0),requestsInFlight:i.u32(1),heightsPerRequest:i.u32(2),viewHorizontalRadius:i.u16(3),viewVerticalRadius:i.u16(4),viewChunks:i.u32(5),windowBytes:Number(i.u64(6)),idleTimeoutMs:i.u32(7),sessionRates:Ch(i.table(8)),addressRates:Ch(i.table(9)),viewHorizon:i.bool(10),viewBase:i.bool(11)}}function fS(i){if(i===null)throw Ut("an Attached without limits");return{voxels:i.u32(0),chunks:i.u32(1),unanswered:i.u32(2),voxelsPerSecond:Number(i.u64(3))}}function pS(i){return{id:i.u16(0),name:i.text(1),colour:i.u32(2),phase:lS[i.u8(3)]??"solid"}}function mS(i){const t=i.u16(4);if(t!==32)throw Ut(`a Welcome with chunks of ${t} voxels; this client knows 32`);const e={protocol:i.u16(0),fingerprint:ys(i,2),storeId:ys(i,3),codec:i.u8(1),materials:i.tables(5,pS),minY:$a(i.i64(6),"min_y"),maxY:$a(i.i64(7),"max_y"),spawn:uS(i,8,"a spawn at"),limits:dS(i.table(9)),server:i.text(10),looks:i.texts(11),fields:i.texts(12),worldFile:i.text(13)};return ld(e),{kind:"welcome",world:e}}function gS(i){const{at:t,count:e}=i.vector(4,12),n=[];for(let s=0;s<e;++s){const r=t+12*s;n.push({firstY:i.data.getInt32(r,!0),lastY:i.data.getInt32(r+4,!0),material:i.data.getUint16(r+8,!0)})}return{kind:"uniform_column",x:i.i32(0),z:i.i32(1),lod:i.u8(2),revision:i.u64(3),runs:n}}function _S(i){const t=i.vector(1,4),e=i.vector(3,4);return{kind:"heights",id:i.u32(0),heightsFx:Int32Array.from({length:t.count},(n,s)=>i.data.getInt32(t.at+4*s,!0)),looks:i.bytesOf(2),values:Float32Array.from({length:e.count},(n,s)=>i.data.getFloat32(e.at+4*s,!0))}}const Ph=2;class vS{constructor(t,e,n){this.options=t,this.tracker=e,this.host=n}local=null;opening=new AbortController;fingerprint="";hasEnded=!1;get isOn(){return this.local?.isOn??!1}joined(t,e){e||(this.stop(),this.fingerprint=""),this.local!==null?t.limits.viewBase?this.local.joined():this.stop():this.options.generate==="always"&&this.begin(t)}viewIsWhole(){const t=this.host.world(),e=globalThis.navigator?.hardwareConcurrency??Ph;this.options.generate==="auto"&&t!==null&&e>=Ph&&this.begin(t)}disconnected(){this.local?.disconnected()}viewApplied(){this.local?.viewApplied()}edited(t){return this.local?.edited(t)??!1}came(t){this.local?.came(t)}serverIsDone(){return this.isOn?(this.local.serverIsDone(),!0):!1}end(){this.hasEnded=!0,this.stop()}begin(t){if(!t.limits.viewBase||t.worldFile===""||this.fingerprint===t.fingerprint)return;const e=xS(this.options.url);if(e===null)return;const{fingerprint:n}=t;this.fingerprint=n;const s=()=>!this.hasEnded&&this.fingerprint===n,{signal:r}=this.opening=new AbortController;let o=!1;const a=l=>{o||!s()||(o=!0,this.fail(l))};il(async()=>{const{LocalChunks:l}=await import("./local_chunks-EwCQRZsj.js");return{LocalChunks:l}},__vite__mapDeps([6,4,2,7,8,5,3]),import.meta.url).then(({LocalChunks:l})=>l.open(this.options,e,t,this.tracker,{...this.host,failed:a},r)).then(l=>{if(!s())return l.end();this.local=l,l.begin(this.host.isViewWhole()),this.host.isViewWhole()||this.host.askAgain()},a)}fail(t){const e=this.isOn;this.stop(),this.host.failed(new Bt("cannot_generate",`chunks are not made here: ${t.message}`)),e&&this.host.askAgain()}stop(){this.opening.abort(),this.local?.end(),this.local=null}}function xS(i){const t=Pl(typeof i=="string"?i:i[0]);return t.protocol!=="ws:"&&t.protocol!=="wss:"?null:(t.protocol=t.protocol==="wss:"?"https:":"http:",t.pathname=t.pathname.replace(/\/v1\/stream$/,"").replace(/\/$/,""),t.href.replace(/\/$/,""))}class SS{debts=new WeakMap;connection=0;takenBytes=0;creditedBytes=0;begin(){++this.connection,this.takenBytes=this.creditedBytes=0}owe(t,e){this.debts.set(t,{connection:this.connection,bytes:e})}taken(t,e){const n=this.debts.get(t);return n===void 0||(this.debts.delete(t),n.connection!==this.connection)||(this.takenBytes+=n.bytes,2*(this.takenBytes-this.creditedBytes)<e)?null:this.creditedBytes=this.takenBytes}}const Lh=200;class MS{constructor(t){this.maxBytes=t}kept=new Map;bytes=0;get size(){return this.kept.size}put(t,e){this.erase(t),this.kept.set(t,{...e,payload:e.payload.slice()}),this.bytes+=e.payload.length+Lh;for(const n of this.kept.keys()){if(this.bytes<=this.maxBytes)break;this.erase(n)}}find(t){return this.kept.get(t)}erase(t){const e=this.kept.get(t);e!==void 0&&(this.kept.delete(t),this.bytes-=e.payload.length+Lh)}clear(){this.kept.clear(),this.bytes=0}entries(){return this.kept}}const wS=32768;class yS{cache;constructor(t){this.cache=new MS(t)}keep({key:t,revision:e,hash:n,payload:s,material:r}){r===null&&n!==null?this.cache.put(Jn(t),{key:t,revision:e,hash:n,payload:s}):this.cache.erase(Jn(t))}find(t,e){const n=this.cache.find(Jn(t));return n?.hash===e?n:void 0}known(t,e,n){const s=[],r=nf(e,n);if(sf(r)>this.cache.size)for(const[,{key:o,hash:a}]of this.cache.entries())s.length<t&&e.covers(o)&&!n?.covers(o)&&s.push({key:o,hash:a});else rf(r,o=>{const a=s.length<t?this.cache.find(Jn(o)):void 0;a!==void 0&&s.push({key:o,hash:a.hash})});return s}edited(t,{key:e,revision:n,previousRevision:s,runs:r}){const o=t.material===null?this.find(e,t.hash)?.payload:hu(t.material);if(o===void 0||r.length===0||s>t.revision)return null;const a=new Uint16Array(wS),l=ol(o,{into:a});l.voxels===null&&a.fill(l.uniform),Jd(r,(h,d,u)=>a.fill(u,h,d));const c=rl({uniform:null,voxels:a});return{key:e,revision:n,hash:au({uniform:null,voxels:a}),payload:c,material:xs(c)}}clear(){this.cache.clear()}}const ES=7/8;class bS{tokens=1/0;most=1/0;perMs=0;at=0;heldUntil=0;begin({sessionRates:t,addressRates:e},n){this.perMs=0,this.tokens=this.most=1/0;for(const s of[t,e])s===null||s.requests===0||this.perMs>0&&s.requests/1e3>=this.perMs||(this.perMs=s.requests/1e3,this.tokens=this.most=Math.max(1,this.perMs*s.burstMs*ES));this.at=n,this.heldUntil=0}refused(t,e){this.heldUntil=Math.max(this.heldUntil,e+of(t))}wait(t){this.tokens=Math.min(this.most,this.tokens+(t-this.at)*this.perMs),this.at=t;const e=this.tokens>=1?0:(1-this.tokens)/this.perMs;return Math.ceil(Math.max(e,this.heldUntil-t,0))}take(){this.tokens-=1}}class TS{open=new Map;lastNonce=0;get isEmpty(){return this.open.size===0}add(t,e,n){return this.open.set(BigInt(++this.lastNonce),{sent:t,resolve:e,reject:n}),this.lastNonce}answered(t,e){const n=this.open.get(t);return n===void 0?null:(this.open.delete(t),n.resolve(e-n.sent),e-n.sent)}refuseOldest(t){const[e]=this.open.entries();e!==void 0&&(this.open.delete(e[0]),e[1].reject(t))}failAll(t){const e=[...this.open.values()];this.open.clear();for(const n of e)n.reject(t)}}class AS{inFlight=new Map;waiting=[];lastId=0;add(t){this.waiting.push(t)}get inFlightCount(){return this.inFlight.size}next(){const t=this.waiting.shift();if(t===void 0)return null;do this.lastId=this.lastId%2147483647+1;while(this.inFlight.has(this.lastId));return this.inFlight.set(this.lastId,t),{id:this.lastId,request:t}}peek(){return this.waiting[0]}find(t){return this.inFlight.get(t)}take(t){const e=this.inFlight.get(t);return this.inFlight.delete(t),e}putBack(t){const e=this.take(t);e!==void 0&&this.waiting.unshift(e)}putAllBack(){this.waiting=[...this.inFlight.values(),...this.waiting],this.inFlight.clear()}failAll(t){this.putAllBack();const e=this.waiting;this.waiting=[];for(const n of e)n.reject(t)}}class RS{constructor(t,e,n,s){this.sender=t,this.pace=e,this.requests=n,this.edits=s}viewWaits=!1;timer;stop(){clearTimeout(this.timer),this.timer=void 0,this.viewWaits=!1}later(t){if(this.timer!==void 0){if(t>0)return;clearTimeout(this.timer)}this.timer=setTimeout(()=>{this.timer=void 0,this.now()},t)}now(){const t=this.sender.openWorld();if(t===null)return;const{limits:e}=t,n=e.frameBytes-2*pd;let s=[];const r=()=>{s.length>0&&this.sender.send($x(s)),s=[]};for(;;){const o=this.pace.wait(performance.now()),a=this.requests.peek()!==void 0&&this.requests.inFlightCount<e.requestsInFlight;if(!this.viewWaits&&!a&&!this.edits.hasNext)break;if(o>0){this.later(o);break}if(this.pace.take(),this.viewWaits){this.viewWaits=!1,this.sender.sendView();continue}if(this.edits.hasNext){const h=this.edits.next(e.frameBytes);h!==null&&this.sender.send(h);continue}const{id:l,request:c}=this.requests.next();c.kind==="chunk"?(s.push({id:l,key:c.key,known:c.known}),ud*(s.length+1)>n&&r()):(r(),this.askPlaces(t,n,l,c))}r()}askPlaces({limits:t,fields:e},n,s,r){const o=c=>this.requests.take(s).reject(new Bt("out_of_range",c)),a=Math.min(t.heightsPerRequest,Math.floor(n/fd)),l=r.fields.map(c=>e.indexOf(c));r.columns.length>a?o(`${r.columns.length} columns; this server takes ${a}`):l.includes(-1)?o(`no field ${r.fields[l.indexOf(-1)]} here; there are: ${e.join(", ")}`):this.sender.send(Yx(s,r.columns,r.looks,l))}}function Ih({code:i,text:t,retryAfterMs:e}){const n=`the server says: ${t}`;switch(i){case"version":case"unauthorized":case"forbidden":case"unsupported":return new Bt("refused",n);case"malformed":case"unexpected":return new Bt("broken_protocol",n);case"too_large":case"too_many_requests":case"out_of_range":return new Bt("out_of_range",n);case"overloaded":return new Bt("overloaded",n,e);case"cancelled":return new Bt("cancelled",n);case"conflict":case"not_applied":return new Bt(i,n);case"timeout":return new Bt("timed_out",n);default:return new Bt("server_failed",n,e)}}class CS{constructor(t,e,n){this.tracker=t,this.kept=e,this.receiver=n}completeToTell=!1;refetching=new Map;uniform=new Map;isToldWhole=!1;keep(t){this.kept.keep(t)}stop(){this.refetching.clear(),this.completeToTell=!1}viewApplied(){this.completeToTell=this.isToldWhole=!1}chunk(t){return this.tracker.shape?.covers(t.key)?(this.receiver.served(),this.kept.keep(t),this.receiver.deliver(t)):!1}unchanged({id:t,key:e,revision:n,hash:s}){if(t!==0)throw Ut(`Unchanged as the answer to request ${t}, which knew of no chunk`);if(!this.tracker.shape?.covers(e))return;this.receiver.served(),this.receiver.countUnchanged();const r=this.tracker.find(e);if(r!==void 0&&n<r.revision)return;if(r?.hash===s)return this.tracker.confirm(r,n);const o=this.kept.find(e,s);o===void 0?this.refetch(e):this.receiver.deliver({key:e,revision:n,hash:s,payload:o.payload.slice(),material:null})}editBroadcast(t){const{key:e,revision:n}=t,s=this.tracker.find(e);if(s===void 0||n<=s.revision)return;const r=this.kept.edited(s,t);if(r===null){this.refetch(e);return}this.kept.keep(r),this.receiver.deliver(r)}uniformColumn({x:t,z:e,lod:n,revision:s,runs:r}){for(const o of r){const a=this.uniformPayload(o.material),l=this.tracker.shape;if(l===null)return;const c=l.rows(n,t,e),h=Math.min(c.last,o.lastY);for(let d=Math.max(c.first,o.firstY);d<=h;++d)if(this.receiver.served(),this.receiver.deliver({key:{lod:n,x:t,y:d,z:e},revision:s,hash:null,payload:a.slice(),material:o.material}),this.receiver.world()===null)return}}uniformPayload(t){let e=this.uniform.get(t);if(e===void 0){if(!this.receiver.world().materials.some(({id:n})=>n===t))throw Ut(`a UniformColumn of material ${t}, which is not in Welcome`);e=hu(t),this.uniform.set(t,e)}return e}viewComplete(){this.completeToTell=!0;for(const t of this.tracker.missing())this.refetching.has(Jn(t))||this.refetch(t);this.tellCompleteIfWhole()}tellCompleteIfWhole(){!this.completeToTell||this.refetching.size>0||this.receiver.world()===null||(this.completeToTell=!1,this.isToldWhole=!0,this.receiver.tellComplete())}refetch(t){const e=Jn(t);if(this.refetching.has(e))return void this.refetching.set(e,!0);this.refetching.set(e,!1),this.receiver.getChunk(t).then(n=>{const s=this.refetching.get(e)??!1;this.refetching.delete(e);const r=this.tracker.find(t)?.revision??-1n;this.tracker.shape?.covers(t)&&n.revision>=r&&this.kept.keep(n),this.receiver.settle(n,this.receiver.deliver(n)),s&&this.receiver.world()!==null&&this.tracker.has(t)&&this.refetch(t),this.tellCompleteIfWhole()},n=>{this.refetching.delete(e),!this.receiver.isClosed()&&(this.tracker.shape?.covers(t)&&this.receiver.failed(n),this.tellCompleteIfWhole())})}}function PS({key:i,revision:t,hash:e,payload:n}){return{key:i,revision:t,hash:e,payload:n,material:xs(n)}}const Bo=2,Dh=4,Nh=4096,LS=1<<20,IS=16<<20,DS=1e4,Uh=2e4,NS=5,US=6e4,FS=8192,OS=2**40;class kS extends uu{constructor(t,e){super(t),this.open=e;for(const[n,s]of[["token",t.token],["clientName",t.clientName]]){const r=new TextEncoder().encode(s??"").length;if(r>Nh)throw new Bt("out_of_range",`${n} has ${r} bytes; at most ${Nh} are allowed`)}this.kept=new yS(t.keepBytes??IS),this.contents=new CS(this.tracker,this.kept,{world:()=>this.connected?this.world:null,isClosed:()=>this.isClosed,served:()=>this.backoff.reset(),deliver:n=>this.deliver(n),settle:(n,s)=>this.settle(n,s),getChunk:n=>this.getChunk(n),failed:n=>this.emit("error",n),countUnchanged:()=>void++this.stats.unchangedChunks,tellComplete:()=>{this.tellComplete(),this.base.viewIsWhole()}}),this.base=new vS(t,this.tracker,{world:()=>this.connected?this.world:null,isViewWhole:()=>this.contents.isToldWhole,deliver:n=>{const s=this.deliver(n);s&&++this.stats.madeChunks,n.hash!==null&&this.contents.keep(n),this.settle(n,s)},refetch:n=>this.contents.refetch(n),compare:(n,s)=>this.compare(n,s),askAgain:()=>{this.connected&&this.tracker.view!==null&&this.viewApplied()},whole:()=>this.contents.viewComplete(),failed:n=>this.emit("error",n)}),this.attempt()}transport=null;connection=0;reader=new Ah;requests=new AS;pace=new bS;kept;pings=new TS;credit=new SS;viewNumber=0;sentShape=null;contents;edits=new sS(()=>this.connected&&this.sending.later(0));sending=new RS({openWorld:()=>this.connected&&this.leaving===null?this.world:null,send:t=>this.send(t),sendView:()=>this.sendView()},this.pace,this.requests,this.edits);base;leaving=null;heardAt=0;deadline;heartbeat;attempt(){const t=++this.connection,e=()=>t===this.connection&&!this.isClosed;this.reader=new Ah,this.credit.begin(),this.leaving=null;const n=this.options.connectTimeoutMs??DS;this.deadline=setTimeout(()=>{this.drop(new Bt("timed_out",`no answer from ${gd(this.options.url).map(Cl).join(", ")} within ${n/1e3} s: it is away, or this program is too busy`))},n);try{this.transport=this.open({opened:()=>e()&&this.sayHello(),received:s=>e()&&this.receive(s,e),ended:s=>e()&&this.drop(this.leaving??s)})}catch(s){const r=new Bt("refused",`the connection cannot be opened: ${s.message}`);queueMicrotask(()=>e()&&this.drop(r))}}sayHello(){this.send(qx({protocolMin:Bo,protocolMax:Bo,codecs:[Dh],token:this.options.token??"",client:this.options.clientName??"talus-client for JavaScript",windowBytes:this.options.windowBytes??LS}))}send(t){this.stats.sentBytes+=t.length,this.transport?.send(t)}drop(t){this.disconnect(),this.connected&&this.pings.failAll(t),this.lost(t)}disconnect(){++this.connection,clearTimeout(this.deadline),clearInterval(this.heartbeat),this.sending.stop(),this.transport?.close(),this.transport=null,this.contents.stop(),this.sentShape=null,this.base.disconnected(),this.requests.putAllBack(),this.edits.connectionEnded()}stopped(){this.disconnect(),this.base.end();const t=this.closedError();this.pings.failAll(t),this.requests.failAll(t),this.edits.failAll(t),this.kept.clear()}receive(t,e){this.stats.receivedBytes+=t.length,this.heardAt=performance.now();try{this.reader.push(t,n=>{e()&&this.handle(hS(n),n.length)})}catch(n){if(!(n instanceof Bt))throw n;e()&&this.drop(n)}}handle(t,e){if(!this.connected){if(t.kind==="welcome")this.handleWelcome(t);else if(t.kind==="error")this.handleFatal(t);else if(t.kind==="go_away")this.handleGoAway(t);else throw Ut(`${t.kind} before Welcome`);return}switch(t.kind){case"chunk":return this.handleChunk(t,e);case"unchanged":return this.handleUnchanged(t);case"uniform_column":return this.contents.uniformColumn(t);case"view_complete":return this.handleViewComplete(t);case"heights":return this.handleHeights(t);case"error":return this.handleError(t);case"edit_broadcast":return this.edits.saw(t.revision),this.base.edited(t)?void 0:this.contents.editBroadcast(t);case"edit_result":return this.backoff.reset(),this.edits.handleResult(t),this.sending.now();case"attached":return this.backoff.reset(),this.edits.handleAttached(t),this.sending.now();case"pong":return this.handlePong(t);case"go_away":return this.handleGoAway(t);default:throw Ut(`an unexpected ${t.kind}`)}}handleWelcome({world:t}){if(t.protocol!==Bo||t.codec!==Dh)throw Ut(`a Welcome for protocol ${t.protocol} and codec ${t.codec}, which were not offered`);clearTimeout(this.deadline),this.pace.begin(t.limits,performance.now()),this.joined(t)}worldKnown(t){t||this.kept.clear(),this.edits.joined(this.world,t),this.base.joined(this.world,t);const e=this.world.limits.idleTimeoutMs||Uh*3;this.heardAt=performance.now(),this.heartbeat=setInterval(()=>this.beat(),Math.max(NS,Math.min(Uh,e/3))),this.sending.now()}beat(){const t=performance.now()-this.heardAt;if(t>US){this.drop(new Bt("timed_out",`the server said nothing for ${Math.round(t/1e3)} s`));return}this.pings.isEmpty&&this.ping().catch(()=>{})}handleChunk(t,e){const{id:n,key:s}=t;this.stats.chunkBytes+=e;const r=PS(t);this.credit.owe(r,e),this.edits.saw(r.revision);let o=!1;if(n!==0){const a=this.requests.find(n);if(a?.kind!=="chunk"||!nc(a.key,s))throw Ut(`chunk ${Jn(s)} as the answer to request ${n}, which did not ask for it`);this.requests.take(n),this.backoff.reset(),o=!0,a.resolve(r),this.sending.now()}else this.base.came(r),o=this.contents.chunk(r);this.settle(r,o)}settle(t,e){(!e||!this.options.manualCredit)&&this.taken(t)}taken(t){if(!this.connected)return;const e=this.credit.taken(t,this.world.limits.windowBytes);e!==null&&this.send(Kx(e))}handleViewComplete({number:t}){t!==this.viewNumber||this.sending.viewWaits||this.tracker.view===null||this.base.serverIsDone()||this.contents.viewComplete()}handleUnchanged(t){const e=t.id===0?void 0:this.requests.find(t.id);if(e?.kind!=="chunk"||e.known===null)return this.contents.unchanged(t);if(!nc(e.key,t.key)||e.known!==t.hash)throw Ut(`Unchanged for another chunk than request ${t.id} knew`);this.requests.take(t.id),this.backoff.reset(),e.unchanged(),this.sending.now()}handleHeights({id:t,heightsFx:e,looks:n,values:s}){const r=this.requests.find(t),o=e.length;if(r?.kind!=="places"||r.columns.length!==o)throw Ut(`${o} heights as the answer to request ${t}, which did not ask for them`);if(n.length!==(r.looks?o:0)||s.length!==o*r.fields.length)throw Ut(`${n.length} looks and ${s.length} values of ${o} columns for request ${t}`);if(n.some(a=>a>=this.world.looks.length))throw Ut("a look that is not in Welcome");this.requests.take(t),this.backoff.reset(),r.resolve({heightsFx:e,looks:r.looks?n:null,values:r.fields.length>0?s:null}),this.sending.now()}handlePong({nonce:t}){const e=this.pings.answered(t,performance.now());if(e===null)throw Ut("a Pong that no Ping asked for");this.stats.latencyMs=e}handleGoAway({reason:t,retryAfterMs:e}){this.leaving=new Bt("disconnected",`the server goes away: ${t}`,e)}handleFatal(t){this.leaving=Ih(t),this.drop(this.leaving)}handleError(t){const e=Ih(t),n=t.code==="overloaded"&&t.retryAfterMs>0;n&&this.pace.refused(t.retryAfterMs,performance.now());const s=t.code==="overloaded"&&(n||this.leaving!==null);switch(t.about){case"request":if(t.requestId>=br)return this.edits.editRefused(t,e,s),this.sending.now();if(this.requests.find(t.requestId)===void 0)throw Ut(`an Error about request ${t.requestId}, which is not in flight`);s?this.requests.putBack(t.requestId):this.requests.take(t.requestId).reject(e),this.sending.now();return;case"view":if(this.sentShape=null,t.viewNumber!==this.viewNumber)return;n?this.sending.viewWaits=!0:this.emit("error",e),this.sending.now();return;case"attach":return this.edits.attachRefused(e,s),this.sending.now();case"view_chunk":t.chunk!==null&&this.tracker.shape?.covers(t.chunk)&&this.contents.refetch(t.chunk);return;case"ping":this.pings.refuseOldest(e);return;case"connection":this.leaving=e;return;default:this.emit("error",e)}}viewApplied(){this.contents.viewApplied(),this.sending.viewWaits=!0,this.viewNumber=this.viewNumber%4294967295+1,this.base.viewApplied(),this.sending.now()}sendView(){const{view:t,shape:e}=this.tracker,n=this.sentShape;if(this.sentShape=t===null?null:e,t===null){const o={centre:{x:OS,y:0,z:0},horizontalRadius:0,verticalRadius:0};this.send(wh(o,this.viewNumber,[]));return}const s=(this.world.limits.frameBytes-2*pd)/dd,r=this.kept.known(Math.min(s,FS),e,n);this.send(wh(t,this.viewNumber,r,this.base.isOn))}getChunk(t){return new Promise((e,n)=>{lu(t),this.ask({kind:"chunk",key:{...t},known:null,resolve:e,reject:n})})}compare(t,e){return++this.stats.proofs,new Promise((n,s)=>this.ask({kind:"chunk",key:t,known:e,resolve:n,unchanged:()=>n(null),reject:s}))}getPlaces(t,e={}){return new Promise((n,s)=>{cu(t);const{looks:r=!1,fields:o=[]}=e;this.ask({kind:"places",columns:[...t],looks:r,fields:[...o],resolve:n,reject:s})})}edit(t){return this.isClosed?Promise.reject(this.closedError()):this.edits.edit(t,this.connected?this.world:null)}editLimits(){return this.isClosed?Promise.reject(this.closedError()):this.edits.askLimits(this.connected?this.world:null)}ask(t){if(this.isClosed)throw this.closedError();this.requests.add(t),this.connected&&this.sending.later(0)}ping(){return new Promise((t,e)=>{if(!this.connected)throw new Bt("disconnected","ping: the client is not connected");this.pace.take(),this.send(Zx(this.pings.add(performance.now(),t,e)))})}}function BS(i){let t=0;return e=>i[t++%i.length](e)}const zS=1;function HS(i,t){const e=t??globalThis.WebSocket;if(e===void 0)throw new Bt("unreachable","there is no WebSocket here: pass one as the option WebSocket, or connect by tcp:// with talus-client/node");return n=>{const s=new e(i);s.binaryType="arraybuffer";let r=!1;const o=a=>{s.onopen=s.onmessage=s.onclose=null,s.onerror=()=>{},n.ended(a)};return s.onopen=()=>{r=!0,n.opened()},s.onmessage=({data:a})=>{if(a instanceof ArrayBuffer){n.received(new Uint8Array(a));return}o(new Bt("broken_protocol","the server sent text, where the protocol has bytes only")),s.close()},s.onerror=()=>{},s.onclose=({code:a,reason:l})=>{const c=l===""?`code ${a}`:`${l} (code ${a})`;o(r?new Bt("disconnected",`the connection to ${i} ended: ${c}`):new Bt("unreachable",`nobody answers at ${i}${tf(i)}`))},{send:a=>{s.readyState===zS&&s.send(a)},close:()=>{s.onopen=s.onmessage=s.onclose=null,s.onerror=()=>{},s.close()}}}}function GS(i){const t=gd(i?.url),[e]=t.map(Pl);return t.length===1&&(e.protocol==="http:"||e.protocol==="https:")?new Hx(i,e):new kS(i,BS(t.map(n=>VS(n,i))))}function VS(i,t){const e=Pl(i);if(e.protocol!=="ws:"&&e.protocol!=="wss:")throw new Bt("unreachable",`url ${Cl(i)}: ws:, wss:, and of one server http: and https: are known here; tcp: and tls: in talus-client/node`);return e.pathname.endsWith("/v1/stream")||(e.pathname=`${e.pathname.replace(/\/$/,"")}/v1/stream`),HS(e.href,t.WebSocket)}function Gr(i,t=null){const{uniform:e,voxels:n}=ol(i,{hash:t});return n??e}class WS{layers=new Map;revision=null}const XS=32768,us=({x:i,y:t,z:e})=>`${i}/${t}/${e}`;function Fh({payload:i,material:t}){const e=t??Gr(i);return typeof e=="number"?new Uint16Array(XS).fill(e):e}const qS=(i,t)=>i.every((e,n)=>e===t[n]);class $S{constructor(t){this.host=t}covered=new Map;get size(){return this.covered.size}begin(t){const e=new WS,n=new Map;for(const{x:s,y:r,z:o,material:a}of t){const l={x:Math.floor(s/32),y:Math.floor(r/32),z:Math.floor(o/32)},c=us(l);let h=e.layers.get(c);h===void 0&&(e.layers.set(c,h=new Map),n.set(c,l)),h.set(((r-l.y*32)*32+o-l.z*32)*32+s-l.x*32,a)}for(const[s,r]of n){const o=this.cover(s,r);if(o===null){e.layers.delete(s);continue}o.predictions.push(e),this.refresh(s,o)}return e}settled(t,e,n){t.revision=n?e:0n,this.eachOf(t,s=>[...t.layers.get(us(s.place))].every(([a,l])=>s.voxels[a]===l)||n&&s.revision>=e)}refused(t){this.eachOf(t,()=>!0)}arrived(t,e,n){const s=us(t),r=this.covered.get(s);return r===void 0?n:(this.put(r,e,n),this.compose(s,r))}behind(t){return t.revision===null?[]:[...this.covered.values()].filter(({predictions:e})=>e.includes(t)).map(({place:e})=>e)}resolved(t,e,n,s){const r=us(e),o=this.covered.get(r);o!==void 0&&(o.predictions=o.predictions.filter(a=>a!==t),n>=o.revision&&this.put(o,n,s),this.refresh(r,o))}left(t){this.covered.delete(us(t))}clear(){this.covered.clear()}cover(t,e){const n=this.covered.get(t);if(n!==void 0)return n;const s=this.host.held(e);if(s===null)return null;const r={payload:s.payload,material:s.material,hash:s.hash},o=Fh(r),a={place:e,revision:-1n,base:r,voxels:o,shown:o,predictions:[]};return this.covered.set(t,a),a}put(t,e,n){t.revision=e,t.base=n,t.voxels=Fh(n),t.predictions=t.predictions.filter(s=>s.revision===null||s.revision>e)}eachOf(t,e){for(const n of t.layers.keys()){const s=this.covered.get(n);s===void 0||!s.predictions.includes(t)||!e(s)||(s.predictions=s.predictions.filter(r=>r!==t),this.refresh(n,s))}}refresh(t,e){const n=this.compose(t,e);n!==null&&this.host.show(e.place,n)}compose(t,e){const{predictions:n,base:s,voxels:r}=e;n.length===0&&this.covered.delete(t);let o=r;if(n.length>0){o=r.slice();for(const{layers:l}of n)for(const[c,h]of l.get(t))o[c]=h}const a=qS(o,e.shown);return e.shown=o,a?null:n.length===0?s:{payload:rl({uniform:null,voxels:o}),material:null,hash:null}}}const YS=(1<<27)-1,KS=32768;function ZS(i,t){const e=(s,r)=>typeof s=="number"?s:s[r];let n=0;for(let s=0;s<KS;s++){if(e(i,s)===e(t,s))continue;const[r,o,a]=[s&31,s>>5&31,s>>10],l=h=>h===0?-1:0,c=h=>h===31?1:0;for(let h=l(a);h<=c(a);h++)for(let d=l(o);d<=c(o);d++)for(let u=l(r);u<=c(r);u++)n|=1<<(h+1)*9+(d+1)*3+u+1}return n}const _d=0,vd=1,Ya=2;function JS(i){const t=i.reduce((s,r)=>Math.max(s,r.id),0),e=new Uint8Array(t+1).fill(Ya),n=new Uint16Array(65536);return i.forEach((s,r)=>{e[s.id]=s.phase==="gas"?_d:s.phase==="liquid"?vd:Ya,n[s.id]=r}),{kinds:e,places:n}}function zo(i,t){const e=i[t]??Ya;return e===_d?"gas":e===vd?"liquid":"solid"}class Oh{values;count=0;constructor(t){this.values=new Float32Array(t)}add(t){this.values[this.count++%this.values.length]=t}percentiles(...t){const e=Math.min(this.count,this.values.length);if(e===0)return null;const n=this.values.slice(0,e).sort();return t.map(s=>n[Math.min(e-1,Math.floor(e*s))])}clear(){this.count=0}}class QS{seconds=new Float64Array(2);second=-1;add(t){this.turn(t),this.seconds[0]++}at(t){this.turn(t);const e=t/1e3%1;return Math.round(this.seconds[0]+this.seconds[1]*(1-e))}turn(t){const e=Math.floor(t/1e3);e!==this.second&&(this.seconds[1]=e===this.second+1?this.seconds[0]:0,this.seconds[0]=0,this.second=e)}}function jS(i,t,e,n,s){const r=Math.hypot(t.x,t.y,t.z);if(!(r>0))return null;const o=[i.x,i.y,i.z],a=[t.x/r,t.y/r,t.z/r],l=o.map(Math.floor),c=a.map(Math.sign),h=a.map(v=>v===0?1/0:Math.abs(1/v)),d=a.map((v,S)=>v===0?1/0:(v>0?l[S]+1-o[S]:o[S]-l[S])*h[S]);let u=0,f=-1;for(;u<=e;){const v=n(l[0],l[1],l[2]);if(v===void 0)return null;if(s(v)){const S=[0,0,0];return f>=0&&(S[f]=-c[f]),{x:l[0],y:l[1],z:l[2],material:v,distance:u,normal:{x:S[0],y:S[1],z:S[2]}}}f=d[0]<d[1]?d[0]<d[2]?0:2:d[1]<d[2]?1:2,u=d[f],d[f]+=h[f],l[f]+=c[f]}return null}const kh=1048575,Tr=(i,t,e)=>((t&kh)*1048576+(e&kh))*8+i,tM=(i,t,e,n)=>`${Tr(i,t,n)}/${e}`;class eM{held=new Map;get(t,e,n){return this.held.get(Tr(t,e,n))}values(){return this.held.values()}add(t){this.held.set(Tr(t.lod,t.x,t.z),t),this.eachAround(t,(e,n)=>{t.near[n]=e,e.near[8-n]=t})}delete(t){this.held.delete(Tr(t.lod,t.x,t.z)),this.eachAround(t,(e,n)=>{t.near[n]=e.near[8-n]=void 0})}eachAround({lod:t,x:e,z:n},s){for(let r=0;r<9;r++){const o=r===4?void 0:this.get(t,e+r%3-1,n+Math.floor(r/3)-1);o!==void 0&&s(o,r)}}}const Ho=(i,t)=>Math.floor(i/t);function nM(i,t){const e=Math.ceil(t/32),n=[];for(let s=1,r=i;s<=6&&r<e;s++)r=s===6?e:Math.min(i*2**s,e),n.push({lod:s,radius:r});return n}function xd(i,t,e,n,s){const r=i.limits,o=Ho(i.minY,32),a=Ho(i.maxY-1,32),l=Math.min(Math.max(Math.ceil((a-o)/2),1),r.viewVerticalRadius),c=Math.max(o+l,Math.min(Ho(t.y,32),a-l));return{centre:{x:Math.floor(t.x),y:c*32+16,z:Math.floor(t.z)},direction:e,horizontalRadius:Math.min(n,r.viewHorizontalRadius),verticalRadius:l,rings:nM(Math.min(n,r.viewHorizontalRadius),s),horizon:r.viewHorizon}}function iM(i,t){const e=[];for(const{lod:n,x:s,y:r,z:o,innerX:a,innerZ:l}of new ef(i,t).boxes){const c={x0:a.first,x1:a.last,z0:l.first,z1:l.last},h=c.x1<c.x0||c.z1<c.z0;e[n]={lod:n,x0:s.first,x1:s.last,z0:o.first,z1:o.last,y0:r.first,y1:r.last,hole:h?null:c}}return e}const Vr=(i,t,e)=>t>=i.x0&&t<=i.x1&&e>=i.z0&&e<=i.z1;function Sd(i,t,e,n){const s=i[t];return s!==void 0&&Vr(s,e,n)&&!(s.hole!==null&&Vr(s.hole,e,n))}function sM(i,t,e,n){const s=i[t];if(s===void 0)return 0;const{hole:r}=s,o=e>s.x0&&e<s.x1&&n>s.z0&&n<s.z1,a=r!==null&&e>=r.x0-1&&e<=r.x1+1&&n>=r.z0-1&&n<=r.z1+1;if(o&&!a)return 511;let l=0;for(let c=0;c<9;c++)Sd(i,t,e+c%3-1,n+Math.floor(c/3)-1)&&(l|=1<<c);return l}function Bh(i,t,e,n){const s=i[t];return s!==void 0&&Vr(s,e,n)}function rM(i){const t=(s,r)=>Math.max(0,r-s+1),e=s=>t(s.x0,s.x1)*t(s.z0,s.z1);let n=0;for(const s of i)s!==void 0&&(n+=(e(s)-(s.hole===null?0:e(s.hole)))*t(s.y0,s.y1));return n}class oM{columns=[];x0=1/0;x1=-1/0;z0=1/0;z1=-1/0;places=[];add(t){this.columns.push(t),this.x0=Math.min(this.x0,t.x),this.x1=Math.max(this.x1,t.x),this.z0=Math.min(this.z0,t.z),this.z1=Math.max(this.z1,t.z)}lay(){if(this.columns.length===0)return;const t=this.x1-this.x0+1;this.places=new Array(t*(this.z1-this.z0+1)).fill(void 0);for(const e of this.columns)this.places[(e.z-this.z0)*t+e.x-this.x0]=e}get(t,e){if(!(t<this.x0||t>this.x1||e<this.z0||e>this.z1))return this.places[(e-this.z0)*(this.x1-this.x0+1)+t-this.x0]}}function aM(i,t){const e=i.length-1,n=i[e],s=Array.from(i,()=>new oM);for(const r of t.values()){const{lod:o,x:a,z:l}=r;o<=e&&Vr(n,a>>e-o,l>>e-o)&&s[o].add(r)}for(const r of s)r.lay();return s}function lM(i,t){const e=[],n=i.length-1;if(n<0)return e;const s=aM(i,t),r=(h,d,u)=>s[h].get(d,u)?.ready?!0:h>0&&o(h,d,u),o=(h,d,u)=>r(h-1,2*d,2*u)&&r(h-1,2*d+1,2*u)&&r(h-1,2*d,2*u+1)&&r(h-1,2*d+1,2*u+1),a=(h,d,u)=>{const f=l(h-1,2*d,2*u),v=l(h-1,2*d+1,2*u),S=l(h-1,2*d,2*u+1),m=l(h-1,2*d+1,2*u+1);return f||v||S||m},l=(h,d,u)=>{const f=s[h].get(d,u);return h>0&&Bh(i,h-1,2*d,2*u)&&Bh(i,h-1,2*d+1,2*u+1)&&o(h,d,u)?a(h,d,u):f?.ready?(e.push(f),!0):h>0&&a(h,d,u)?!0:f?.begun?(e.push(f),!0):!1},c=i[n];for(let h=c.z0;h<=c.z1;h++)for(let d=c.x0;d<=c.x1;d++)l(n,d,h);return e}function cM(i,t,e,n){let s=1/0;for(const r of i){if(r===void 0)continue;const o=32*2**r.lod;for(let a=r.z0;a<=r.z1;a++)for(let l=r.x0;l<=r.x1;l++){if(!Sd(i,r.lod,l,a)||t.get(r.lod,l,a)?.ready)continue;const c=Math.max(l*o-e,e-(l+1)*o,0),h=Math.max(a*o-n,n-(a+1)*o,0);s=Math.min(s,c*c+h*h)}}return s===1/0?null:Math.sqrt(s)}function hM(i,t,e){let n=null,s=null,r=1024,o=!0;for(let l=t.y1;l>=t.y0&&r>0;l--){const c=i.chunks.get(l);if(c===void 0||c.meshedWith<0){o=!1;continue}const h=c.material===null?null:e(c.material);if(!(h==="gas"||h===null&&c.tops===null)){if(n??=new Int16Array(1024).fill(Dn),h==="liquid"||c.liquidTops!==null){s??=new Int16Array(1024).fill(Dn);for(let d=0;d<1024;d++){const u=h==="liquid"?32:c.liquidTops[d];u>0&&n[d]===Dn&&s[d]===Dn&&(s[d]=l*32+u)}}if(h!=="liquid")for(let d=0;d<1024;d++){if(n[d]!==Dn)continue;const u=h==="solid"?32:c.tops[d];u!==0&&(n[d]=l*32+u,r--)}}}if(i.ready=o,n===null&&s===null)return!1;i.heights=n,i.liquids=s;let a=32767;if(n!==null)for(let l=0;l<1024;l++)n[l]<a&&(a=n[l]);return i.lowest=n===null?Dn:a,!0}const uM=120,dM=32;class fM{constructor(t){this.sliceOf=t}chunks=[];isSorted=!1;sortedAt=-1/0;get length(){return this.chunks.length}add(t){t.queued=!0,this.chunks.push(t),this.isSorted=!1}clear(){this.chunks=[]}moved(){this.isSorted=!1}forEachNext(t,e,n){if(this.chunks.length===0)return;!this.isSorted&&t-this.sortedAt>uM&&this.sort(t,e);const s=[];for(;this.chunks.length>0&&s.length<dM;){const r=this.chunks.pop();r.queued=!1,!n(r)&&(r.queued=!0,s.push(r))}for(let r=s.length-1;r>=0;r--)this.chunks.push(s[r])}sort(t,e){this.sortedAt=t;for(const n of this.chunks)n.order=this.distance(n,e);this.chunks.sort((n,s)=>s.order-n.order),this.isSorted=!0}distance(t,e){const n=32*2**t.lod,s=(t.x+.5)*n-e.x,r=(t.y+.5)*n-e.y,o=(t.z+.5)*n-e.z;return t.hurried?Math.hypot(s,o)-1e5:Math.hypot(s,o)+(r>0?r*.25:-r*.5)+(t.meshedWith>=0&&t.meshedSlice===this.sliceOf(t)?200:0)}}const pM=80,mM=40,gM=240,_M=1,vM=4,xM=4;class SM{constructor(t){this.options=t}shape=[];slice=null;columns=new eM;jobs=new Map;queue=new fM(t=>this.sliceOf(t));nextJob=1;coverStale=!0;stale=new Set;toRefresh=null;leaving=new Set;coveredAt=-1/0;coverMs=0;cover=[];version=0;covers=0;coverVersion=0;camera={x:0,y:0,z:0};held=0;payloadBytes=0;heldPerLevel=[0,0,0,0,0,0,0];get(t,e,n){return this.columns.get(t,e,n)}values(){return this.columns.values()}get settled(){return this.queue.length===0&&this.jobs.size===0&&!this.coverStale&&this.stale.size===0}get waiting(){return this.queue.length+this.jobs.size}get drawn(){return this.cover}nearestMissing(t,e){return cM(this.shape,this,t,e)}setShape(t){const e=t.map((n,s)=>n?.y0!==this.shape[s]?.y0||n?.y1!==this.shape[s]?.y1);this.shape=t;for(const n of this.columns.values()){const s=n.around;if(this.placeInShape(n),s===n.around&&!e[n.lod])continue;const r=t[n.lod];for(const o of n.chunks.values())n.wanted&&o.y>=r.y0&&o.y<=r.y1?this.consider(o):this.leave(o.lod,o.x,o.y,o.z)}this.coverStale=!0}setSlice(t){this.slice=t;for(const e of this.columns.values()){const n=this.isCut(e);if(n||e.cut)for(const s of e.chunks.values())this.consider(s);e.cut=n}this.version++}add(t,e,n,s,r,o,a=YS,l=null){let c=this.get(t,e,s);c===void 0&&(c=new kv(t,e,s),this.columns.add(c),this.placeInShape(c));let h=c.chunks.get(n);const d=h===void 0;h===void 0&&(h=new Ov(c,n),c.chunks.set(n,h));const u=h.left;(d||u)&&(this.held++,this.heldPerLevel[t]++),u&&c.left--,h.left=!1,this.payloadBytes+=(r?.length??0)-(h.payload?.length??0),h.payload=r,h.material=o,h.hash=l,h.arrived=this.options.now(),h.changed=!0,h.hurried=!d&&!u,this.options.meshers.send(h),this.eachNeighbour(h,(f,v)=>{f.left||(h.known|=1<<v,f.known|=1<<26-v,!d&&a>>>v&1&&(f.changed=!0,f.hurried=!u),this.consider(f))}),this.consider(h)}leave(t,e,n,s){const r=this.get(t,e,s)?.chunks.get(n);r===void 0||r.left||(r.left=!0,r.column.left++,this.leaving.add(r.column),this.payloadBytes-=r.payload?.length??0,r.payload=null,r.known=0,this.held--,this.heldPerLevel[t]--,this.options.meshers.drop(r),this.eachNeighbour(r,(o,a)=>{o.known&=~(1<<26-a)}),r.job!==null&&this.cancel(r),r.drawable===null&&r.meshedWith<0&&this.forget(r),this.coverStale=!0)}meshed(t,e){const n=this.jobs.get(t);if(this.jobs.delete(t),n===void 0||n.job?.id!==t)return;const s=n.job;n.job=null;const r=e.quads.length>0?this.options.drawer.add(s.slot,e):null;r===null&&this.options.drawer.freeSlot(s.slot),n.meshedWith<0&&this.options.arrivedToDrawn(this.options.now()-n.arrived),this.replace(n,r,s.known,s.slice),s.slice===null&&(n.tops=e.tops,n.liquidTops=e.liquidTops,this.stale.add(n.column)),this.consider(n)}failed(t){const e=this.jobs.get(t);this.jobs.delete(t),e?.job?.id===t&&(this.options.drawer.freeSlot(e.job.slot),e.job=null)}update(t){const e=this.options.now();if(Math.abs(t.x-this.camera.x)+Math.abs(t.z-this.camera.z)>24&&(this.camera={...t},this.queue.moved()),this.dispatch(),this.toRefresh===null){if(!this.coverStale&&this.stale.size===0||!this.isDue(e))return;this.coveredAt=e,this.toRefresh=this.stale.size}this.refresh(e,this.toRefresh),this.toRefresh===null&&this.recover()}isDue(t){return t-this.coveredAt>Math.min(gM,Math.max(pM,mM*this.coverMs))||this.cover.length===0}loseMeshes(){for(const t of this.cover)t.drawn=!1;this.cover=[];for(const t of this.columns.values()){t.ready=t.begun=!1,this.stale.add(t);for(const e of t.chunks.values())e.drawable!==null&&this.options.drawer.remove(e.drawable),e.drawable=null,e.meshedWith=-1,e.left?this.forget(e):this.consider(e);t.gather()}this.coverStale=!0}clear(){for(const t of[...this.columns.values()])for(const e of t.chunks.values())this.leave(e.lod,e.x,e.y,e.z),this.forget(e);this.queue.clear(),this.stale.clear(),this.toRefresh=null,this.coverStale=!0,this.recover()}placeInShape(t){t.around=sM(this.shape,t.lod,t.x,t.z),t.wanted=(t.around&16)!==0}wantedAround(t){const e=this.shape[t.lod];if(e===void 0)return 0;const n=t.column.around;let s=(n&-17)<<9;return t.y>e.y0&&(s|=n),t.y<e.y1&&(s|=n<<18),s}eachNeighbour(t,e){const{near:n}=t.column;for(let s=0;s<9;s++){const r=n[s];if(r!==void 0)for(let o=-1;o<=1;o++){if(s===4&&o===0)continue;const a=r.chunks.get(t.y+o);a!==void 0&&e(a,(o+1)*9+s)}}}consider(t){if(t.left||t.queued||t.job!==null||(this.wantedAround(t)&~t.known)!==0)return;const n=this.sliceOf(t);if(!(t.meshedWith>=0&&!t.changed&&(t.known&~t.meshedWith)===0&&t.meshedSlice===n)){if(this.isPlain(t)){const r=t.meshedWith<0;this.replace(t,null,t.known,n),t.changed=t.hurried=!1,(r||t.tops!==null)&&(t.tops=null,this.stale.add(t.column));return}this.queue.add(t)}}sliceOf(t){return this.isCut(t.column)?this.slice:null}isCut(t){if(this.slice===null)return!1;const e=32*2**t.lod;return ka(this.slice,(t.x-1/32)*e,(t.z-1/32)*e,e*1.0625)==="cut"}isPlain(t){if(t.material===null)return!1;const e=this.options.kindOf(t.material);if(e==="gas")return!0;if(this.sliceOf(t)!==null)return!1;let n=!0;const s=(r,o,a)=>{const l=(o+1)*9+(a+1)*3+r+1;if(!n||!(t.known>>>l&1))return;const c=t.column.near[(a+1)*3+r+1]?.chunks.get(t.y+o);if(c===void 0||c.material===null){n=!1;return}const h=this.options.kindOf(c.material);h==="solid"||h===e||(n=!1)};return s(-1,0,0),s(1,0,0),s(0,-1,0),s(0,1,0),s(0,0,-1),s(0,0,1),n}replace(t,e,n,s){t.drawable!==null&&this.options.drawer.remove(t.drawable);const r=t.drawable!==null;t.drawable=e,(r||e!==null)&&t.column.gather(),t.meshedWith=n,t.meshedSlice=s;const{column:o}=t;!o.begun&&e!==null&&(o.begun=this.coverStale=!0),o.ready||this.stale.add(o),this.version++}dispatch(){this.queue.forEachNext(this.options.now(),this.camera,t=>{if(t.left||(this.wantedAround(t)&~t.known)!==0)return!0;if(!this.options.meshers.hasRoom(t))return!1;const e=this.sliceOf(t),n=this.options.drawer.takeSlot(t.lod,t.x,t.y,t.z),s=this.nextJob++;return t.job={id:s,known:t.known,slice:e,slot:n},t.changed=t.hurried=!1,this.jobs.set(s,t),this.options.meshers.mesh(t,{id:s,lod:t.lod,x:t.x,y:t.y,z:t.z,slot:n,known:t.known,slice:e}),!0})}cancel(t){this.jobs.delete(t.job.id),this.options.drawer.freeSlot(t.job.slot),t.job=null}forget(t){const{column:e}=t;t.left&&e.left--,e.chunks.delete(t.y),t.drawable!==null&&(this.options.drawer.remove(t.drawable),t.drawable=null,e.gather()),e.chunks.size===0&&(this.columns.delete(e),this.leaving.delete(e),this.stale.delete(e))}refresh(t,e){if(this.stale.size===0){this.toRefresh=null;return}const n=this.cover.length===0?vM:_M;let s=0;for(const r of this.stale){if(s===e||s>=xM&&this.options.now()-t>n)break;s++,this.stale.delete(r);const o=this.shape[r.lod];if(o===void 0)continue;const{ready:a}=r;hM(r,o,this.options.kindOf)&&this.options.heights(r),this.coverStale||=a!==r.ready}this.toRefresh=s<e&&this.stale.size>0?e-s:null,this.version++}recover(){if(!this.coverStale)return;this.coverStale=!1;const t=this.options.now();this.version++,this.drawAnew(),this.coverMs=this.options.now()-t}drawAnew(){const t=this.cover;this.cover=lM(this.shape,this),this.covers++;const e=[];for(const n of this.cover)n.coveredIn=this.covers,n.drawn||e.push(n);for(const n of t)n.coveredIn!==this.covers&&e.push(n);e.length>0&&this.coverVersion++;for(const n of e)n.drawn=n.coveredIn===this.covers;for(const n of e)for(const s of[1,3,4,5,7])n.near[s]?.findSkirts();for(const n of this.leaving)if(n.left===0&&this.leaving.delete(n),!(n.left===0||n.drawn&&(!n.wanted||!n.ready)))for(const s of n.chunks.values())s.left&&this.forget(s)}}class MM{constructor(t,e,n){this.options=t,this.events=e,this.isFull=n}client;hasEnded=!1;isClosed=!1;untaken=[];open(t){const e=this.options.source?.()??this.connected(t);this.client=e,this.hasEnded=!1;const{events:n}=this,s=()=>e===this.client&&!this.isClosed;e.on("connected",(o,a)=>s()&&n.connected(o,a)),e.on("chunk",o=>{s()&&(n.chunk(o),this.isFull()?this.untaken.push(o):e.taken(o))}),e.on("chunkLeft",o=>s()&&n.left(o)),e.on("viewComplete",()=>s()&&n.viewComplete()),e.on("disconnected",(o,a)=>{s()&&a!==null&&n.lost(o.message,!1)}),e.on("error",o=>s()&&n.error(o.message)),e.on("closed",o=>{s()&&(this.hasEnded=!0,o!==null&&n.lost(o.message,o.kind==="refused"))});const r=e.ready();return r.catch(()=>{}),r}connected(t){const e=new URL(this.options.url);return this.options.transport==="websocket"&&(e.protocol=e.protocol==="https:"?"wss:":"ws:"),GS({url:e.href,token:t,clientName:"talus-viewer",manualCredit:!0,generate:"auto"})}hurry(){return this.hasEnded||this.client.retry(),!this.hasEnded}takeBacklog(){for(;this.untaken.length>0&&!this.isFull();)this.client.taken(this.untaken.shift())}close(){this.isClosed=!0,this.client.close()}drop(){this.client.close()}}const wM=-1,yM=-2;class EM{rows=[];payloads=[];hashes=[];bytes=0;get isEmpty(){return this.rows.length===0}add({lod:t,x:e,y:n,z:s,payload:r,material:o,hash:a}){const l=o===null?r:null;this.rows.push(t,e,n,s,o??wM,l?.length??0),l!==null&&(this.payloads.push(l),this.hashes.push(a),this.bytes+=l.length)}drop({lod:t,x:e,y:n,z:s}){this.rows.push(t,e,n,s,yM,0)}take(){const t=new Uint8Array(this.bytes);let e=0;for(const r of this.payloads)t.set(r,e),e+=r.length;const n=Int32Array.from(this.rows),{hashes:s}=this;return this.hashes=[],this.rows.length=this.payloads.length=this.bytes=0,{table:n,payloads:t,hashes:s}}}const hr=3,bM=6,TM=i=>Math.min(4,Math.max(2,i-1));class AM{constructor(t,e,n,s){this.handle=n,this.broken=s,this.crews=Array.from({length:t},()=>{const r={worker:e(),jobs:0,changes:new EM,orders:[],heldBytes:0};return r.worker.onmessage=o=>this.answered(r,o.data),r.worker.onerror=({message:o})=>this.broken(o||"it did not start"),r.worker.onmessageerror=()=>this.broken("a message that cannot be read"),r})}crews;ownerOfJob=new Map;meshMs=0;meshes=0;get heldBytes(){return this.crews.reduce((t,e)=>t+e.heldBytes,0)}get meanMs(){return this.meshes===0?0:this.meshMs/this.meshes}setWorld(t,e){for(const n of this.crews)this.post(n,{kind:"world",kinds:t,places:e})}send(t){for(const e of this.holdersOf(t))e.changes.add(t)}drop(t){for(const e of this.holdersOf(t))e.changes.drop(t)}hasRoom(t){return this.ownerOf(t.lod,t.x,t.z).jobs<bM}mesh(t,e){const n=this.ownerOf(t.lod,t.x,t.z);n.jobs++,n.orders.push(e),this.ownerOfJob.set(e.id,n)}flush(){for(const t of this.crews)this.flushCrew(t)}dispose(){for(const t of this.crews)t.worker.terminate()}flushCrew(t){if(t.changes.isEmpty&&t.orders.length===0)return;const e=t.changes.isEmpty?null:t.changes.take(),n=e===null?[]:[e.table.buffer,e.payloads.buffer];this.post(t,{kind:"work",changes:e,jobs:t.orders.splice(0)},n)}post(t,e,n=[]){t.worker.postMessage(e,n)}ownerOf(t,e,n){const s=this.crews.length,r=(e>>hr)+(n>>hr)+t;return this.crews[(r%s+s)%s]}holdersOf({lod:t,x:e,z:n}){const s=o=>o+1>>hr===o-1>>hr;if(s(e)&&s(n))return[this.ownerOf(t,e,n)];const r=new Set;for(let o=-1;o<=1;o++)for(let a=-1;a<=1;a++)r.add(this.ownerOf(t,e+a,n+o));return r}answered(t,e){this.ownerOfJob.delete(e.id)&&t.jobs--,e.kind==="meshed"&&(this.meshMs+=e.ms,this.meshes++,t.heldBytes=e.heldBytes),this.handle(e)}}const RM=250,CM=Math.PI/6;class PM{chunks="";yaw=0;at=-1/0;get hasSent(){return this.chunks!==""}reset(){this.chunks="",this.at=-1/0}next(t,e,n,s,r,o){if(t-this.at<RM)return null;const{yaw:a,pitch:l}=n,c={x:Math.sin(a)*Math.cos(l),y:Math.sin(l),z:-Math.cos(a)*Math.cos(l)},h=xd(e,n,c,s,r),{x:d,y:u,z:f}=h.centre,v=M=>Math.floor(M/32),S=JSON.stringify([v(d),v(u),v(f),h.horizontalRadius,h.verticalRadius,h.rings]),m=Math.abs(Math.atan2(Math.sin(a-this.yaw),Math.cos(a-this.yaw)))>CM,p=S!==this.chunks;return!p&&!(m&&!o)?null:(this.chunks=S,this.yaw=a,this.at=t,{view:h,moved:p})}}const LM=128;class IM{constructor(t){this.chunkAt=t}decoded=new Map;get bytes(){return this.decoded.size*65536}atBlock(t,e,n,s){const r=this.chunkAt(Math.floor(t/32),Math.floor(e/32),Math.floor(n/32));if(r===void 0||r.left)return e>=s?0:void 0;const o=a=>(a%32+32)%32;return this.at(r,o(t),o(e),o(n))}at(t,e,n,s){if(t.material!==null)return t.material;if(t.payload===null)return;const r=tM(t.lod,t.x,t.y,t.z);let o=this.decoded.get(r);if((o===void 0||o.payload!==t.payload)&&(o={payload:t.payload,voxels:DM(t.payload,t.hash)},this.decoded.set(r,o),this.decoded.size>LM&&this.decoded.delete(this.decoded.keys().next().value)),o.voxels!==null)return typeof o.voxels=="number"?o.voxels:o.voxels[dx(e,n,s)]}clear(){this.decoded.clear()}}function DM(i,t){try{return Gr(i,t)}catch{return null}}const NM=3e3,UM=3e3;class Ll{constructor(t){this.options=t,this.radius=t.radius,this.horizon=t.horizon,this.token=t.token,this.reducedMotion=t.reducedMotion,this.link=new MM(t,{connected:(e,n)=>this.onConnected(e,n),chunk:e=>{const{lod:n,x:s,y:r,z:o}=e.key;this.rate.add(performance.now());const a=n===0?this.predictions.arrived(e.key,e.revision,e):e;a!==null&&this.addChunk(n,s,r,o,a)},left:e=>{e.lod===0&&this.predictions.left(e),this.land.leave(e.lod,e.x,e.y,e.z)},viewComplete:()=>{this.viewComplete=!0,this.workSoon()},lost:(e,n)=>this.setState(n?"refused":"lost",e),error:e=>this.emit("error",e)},()=>this.land.waiting>=NM),this.joined=this.link.open(this.token),this.pool=new AM(TM(navigator.hardwareConcurrency??2),()=>new Worker(new URL(""+new URL("worker-iEGWM72J.js",import.meta.url).href,import.meta.url),{type:"module"}),e=>{this.disposed||(this.workSoon(),e.kind==="meshed"?this.land.meshed(e.id,e.mesh):(this.land.failed(e.id),e.text!=="not held"&&this.emit("error",`a chunk does not decode: ${e.text}`)))},e=>this.emit("error",`a worker that makes meshes ended: ${e}`));try{this.frames=new gx(t.canvas,t.quality)}catch(e){throw this.link.close(),this.pool.dispose(),new Error(`this browser cannot draw the world: it needs WebGL 2 (${e.message})`)}this.land=new SM({drawer:this.frames.terrain,meshers:this.pool,kindOf:e=>zo(this.kinds,e),now:()=>performance.now(),heights:e=>{this.frames.ground?.set(e),e.liquids!==null&&this.seaLevel===null&&this.seeSea(e.liquids,e.lod)},arrivedToDrawn:e=>this.latency.add(e)}),this.predictions=new $S({held:({x:e,y:n,z:s})=>{const r=this.land.get(0,e,s)?.chunks.get(n);return r===void 0||r.left?null:r},show:({x:e,y:n,z:s},r)=>this.addChunk(0,e,n,s,r)}),this.editing=new Ex(this.predictions,()=>this.disposed?null:this.link.client),t.canvas.addEventListener("webglcontextlost",this.onContextLost),t.canvas.addEventListener("webglcontextrestored",this.onContextRestored)}static async create(t){const e=new Ll(t);try{await e.joined}catch(n){throw e.dispose(),n}return e}info=null;link;joined;frames;pool;land;voxels=new IM((t,e,n)=>this.land.get(0,t,n)?.chunks.get(e));handlers=new Map;kinds=new Uint8Array;state="connecting";viewComplete=!1;complete=!1;eye={x:0,y:0,z:0,yaw:0,pitch:0};views=new PM;chunksWanted=0;radius;horizon;token;slice=null;selection=null;marker=null;predictions;editing;nearestFirst=new yx;lost=!1;disposed=!1;started=performance.now();hasPicture=!1;firstFrameMs=null;completeMs=null;latency=new Oh(1024);cpu=new Oh(256);updated=0;rate=new QS;seaLevel=null;drawnVersion=-1;reducedMotion;wantsPicture=[];get world(){if(this.info===null)throw new Error("the engine has not joined yet");return{...this.info,seaLevel:this.seaLevel}}setCamera(t,e,n,s,r){this.eye={x:t,y:e,z:n,yaw:s,pitch:r}}setFov(t){this.frames.setFov(t)}resize(t,e,n){this.frames.resize(t,e,n)}update(){if(this.disposed)return;const t=performance.now();this.sendView(t),this.work(),this.updated+=performance.now()-t}frame(t){if(this.disposed)return;const e=performance.now();!this.lost&&this.info!==null&&this.draw(t),this.cpu.add(performance.now()-e+this.updated),this.updated=0}voxelAt(t,e,n){return this.voxels.atBlock(t,e,n,this.info?.maxY??1/0)}raycast(t,e,n,s=!1){return jS(t,e,n,(r,o,a)=>this.voxelAt(r,o,a),r=>this.isSolid(r)||s&&this.isLiquid(r))}isSolid(t){return zo(this.kinds,t)==="solid"}isLiquid(t){return zo(this.kinds,t)==="liquid"}setTimeOfDay(t){this.frames.setTimeOfDay((t%24+24)%24)}setSlice(t){const e=this.slice?.x===t?.x&&this.slice?.z===t?.z&&this.slice?.yaw===t?.yaw;this.slice=t,!e&&this.land.setSlice(t===null?null:{x:t.x,z:t.z,nx:Math.sin(t.yaw),nz:-Math.cos(t.yaw)})}setChunkBorders(t){this.frames.setBorders(t)}setSelection(t){this.selection=t}setMarker(t){this.marker=t}get whyNoEdits(){return this.options.transport==="http"&&this.options.source===void 0?"By HTTP one only looks. The settings have WebSocket, which takes edits.":this.info===null?"The world is not here yet.":/^0*$/.test(this.info.storeId)?"This server keeps no edits: it has no place to store them.":null}editLimits(){return this.link.client.editLimits()}edit(t,e){return this.editing.edit(this.link.client,t,e)}setRadius(t,e){t===this.radius&&e===this.horizon||(this.radius=t,this.horizon=e,this.info!==null&&this.makeGround())}setQuality(t){this.frames.setQuality(t)}setReducedMotion(t){this.reducedMotion=t}setToken(t){this.token=t,this.reconnect()}hurry(){this.link.hurry()||this.reconnect()}reconnect(){this.link.drop(),this.setState("connecting",""),this.joined=this.link.open(this.token)}screenshot(){return new Promise((t,e)=>{this.wantsPicture.push(n=>n?t(n):e(new Error("the browser made no picture")))})}stats(){const t=performance.now(),{latency:e,cpu:n,land:s,eye:r}=this;return{state:this.state,chunks:this.land.held,chunksPerLevel:[...this.land.heldPerLevel],chunksWanted:this.chunksWanted,pendingMeshes:this.land.waiting,meshes:this.frames.terrain.meshes,current:this.land.version===this.drawnVersion,triangles:this.frames.triangles,drawCalls:this.frames.drawCalls,receivedBytes:this.link.client.stats.receivedBytes,madeChunks:this.link.client.stats.madeChunks,receivedChunks:this.link.client.stats.chunks-this.link.client.stats.madeChunks,get latency(){const o=e.percentiles(.5,.95,.99);return o&&{p50:o[0],p95:o[1],p99:o[2]}},chunkRate:this.rate.at(t),get nearestMissing(){return s.nearestMissing(r.x,r.z)},gpuBytes:this.frames.gpuBytes,heapBytes:this.pool.heldBytes+this.voxels.bytes+this.land.payloadBytes,get frameCpu(){const[o,a]=n.percentiles(.5,.95)??[0,0];return{p50:o,p95:a}},meshMs:this.pool.meanMs,hasPicture:this.hasPicture,firstFrameMs:this.firstFrameMs,completeMs:this.completeMs}}on(t,e){let n=this.handlers.get(t);return n===void 0&&this.handlers.set(t,n=new Set),n.add(e),()=>void n.delete(e)}dispose(){this.disposed||(this.disposed=!0,this.options.canvas.removeEventListener("webglcontextlost",this.onContextLost),this.options.canvas.removeEventListener("webglcontextrestored",this.onContextRestored),this.link.close(),this.pool.dispose(),this.frames.dispose())}onConnected(t,e){const n=this.info===null||!e||this.info.fingerprint!==t.fingerprint;n&&(this.info!==null&&(this.land.clear(),this.predictions.clear(),this.voxels.clear()),this.info={...t,seaLevel:null},this.seaLevel=null,this.prepareMaterials(t),this.makeGround(),!this.views.hasSent&&this.eye.x===0&&this.eye.z===0&&(this.eye={...this.eye,x:t.spawn.x+.5,y:t.spawn.y+1.6,z:t.spawn.z+.5})),this.setState("streaming",""),this.views.hasSent&&(this.views.reset(),this.sendView(performance.now())),this.emit("world",this.world,!n)}addChunk(t,e,n,s,{payload:r,material:o,hash:a}){const l=this.land.get(t,e,s)?.chunks.get(n),c=l!==void 0&&!l.left&&l.meshedWith>=0;let h;if(c)try{h=ZS(l.material??Gr(l.payload),o??Gr(r))}catch{}this.land.add(t,e,n,s,r,o,h,a),this.workSoon()}prepareMaterials(t){const e=t.materials.slice(0,sx),{kinds:n,places:s}=JS(e);this.kinds=n,this.pool.setWorld(n,s),this.frames.setMaterials(Sx(e))}makeGround(){const t=xd(this.info,this.eye,{x:0,y:0,z:0},this.radius,this.horizon).rings.length+1,e=Math.round((this.info.minY+this.info.maxY)/128)*64;this.groundBase=this.info.maxY-this.info.minY<2e3?0:e;const n=this.frames.ground;if(!(n!==null&&n.isFor(this.radius,t,this.groundBase)&&!this.lost)){this.frames.setGround(new qv(this.frames.renderer,this.radius,t,this.groundBase));for(const s of this.land.values())(s.heights!==null||s.liquids!==null)&&this.frames.ground.set(s)}}groundBase=0;seeSea(t,e){for(const n of t)if(!(n<=-32768)){this.seaLevel=n*2**e;return}}sendView(t){const e=this.info&&this.views.next(t,this.info,this.eye,this.radius,this.horizon,this.complete);if(e===null)return;const{view:n,moved:s}=e;try{this.link.client.setView(n)}catch(c){this.emit("error",c.message);return}if(!s)return;const r=iM(n,this.info);this.land.setShape(r),this.chunksWanted=rM(r),this.viewComplete=this.complete=!1,this.state==="complete"&&this.setState("streaming","");const o=c=>Math.floor(c/32)*32+16,{x:a,z:l}=n.centre;this.frames.setReach(o(a),o(l),n.horizontalRadius*32,this.reach(n))}work(){this.link.takeBacklog(),this.land.update(this.eye),this.pool.flush(),this.settle(performance.now())}workSoon(){this.working||(this.working=!0,setTimeout(()=>{this.working=!1,this.disposed||this.work()},6))}working=!1;settle(t){!this.viewComplete||this.complete||!this.land.settled||(this.complete=!0,this.completeMs??=t-this.started,this.state==="streaming"&&this.setState("complete",""))}draw(t){const{eye:e}=this;this.land.version!==this.drawnVersion&&this.frames.landChanged();const n=this.options.frozenTime??(this.reducedMotion?0:null),s=Dv(c=>{const h=this.voxelAt(Math.floor(e.x),Math.floor(c),Math.floor(e.z));return h!==void 0&&this.isLiquid(h)},e.y),r=this.land.get(0,Math.floor(e.x/32),Math.floor(e.z/32)),o=c=>(Math.floor(c)%32+32)%32,a=r?.heights?.[o(e.z)*32+o(e.x)]??-32768;if(this.frames.draw({eye:e,columns:this.nearestFirst.update(this.land.drawn,this.land.coverVersion,e.x,e.z),seconds:n??t/1e3,now:performance.now(),slice:this.land.slice,selected:this.selection,marker:this.marker,seaLevel:this.seaLevel,underWater:s.under,closeToWater:s.close,hideBuried:this.land.slice===null&&e.y>a-4,groundBase:this.groundBase,onlyWithLand:!this.hasPicture&&!this.complete&&performance.now()-this.started<UM})){this.hasPicture=!0,this.drawnVersion=this.land.version,this.firstFrameMs===null&&this.frames.triangles>1&&(this.firstFrameMs=performance.now()-this.started);for(const c of this.wantsPicture.splice(0))this.options.canvas.toBlob(c,"image/png")}}reach(t){const e=32*(t.rings?.at(-1)?.radius??t.horizontalRadius);return this.horizon===0?e:Math.min(this.horizon,e)}setState(t,e){t===this.state&&e===""||(this.state=t,this.emit("state",t,e))}emit(t,...e){for(const n of this.handlers.get(t)??[])n(...e)}onContextLost=t=>{t.preventDefault(),this.lost=!0,this.emit("contextLost")};onContextRestored=()=>{this.frames.contextRestored(),this.land.loseMeshes(),this.info!==null&&this.makeGround(),this.lost=!1,this.complete=!1,this.state==="complete"&&this.setState("streaming",""),this.emit("contextRestored")}}const FM=500,OM=15e3,zh=2e3,kM=6e3,Hh=i=>/token|unauthori[sz]ed/i.test(i);class BM{constructor(t,e,n,s,r,o){this.stage=t,this.settings=e,this.server=n,this.tokens=s,this.isReduced=r,this.listener=o,addEventListener("online",()=>this.hurry()),document.addEventListener("visibilitychange",()=>{document.visibilityState==="visible"&&this.hurry()})}engine=null;began=0;#t=0;#e=0;#n=0;#i;#s;#r=null;#a=!1;async open(){this.#l(),this.#n=0;const t=++this.#t,e=await this.server.obstacle();if(t!==this.#t)return;if(e!==null)return this.#f(e);const n=document.createElement("canvas");n.id="view",this.stage.querySelector("canvas")?.remove(),this.stage.prepend(n);const{token:s}=this.tokens;let r;this.#s=setTimeout(()=>void this.#h(t),zh),this.began=performance.now();try{r=await Ll.create({canvas:n,url:this.server.base.replace(/\/$/,""),transport:this.settings.transport,...this.server.source===null?{}:{source:this.server.source},...s===null?{}:{token:s},radius:this.settings.radius,horizon:this.settings.horizon,quality:this.settings.quality,reducedMotion:this.isReduced()})}catch(o){t===this.#t&&await this.#d(t,o instanceof Error?o.message:String(o));return}if(t!==this.#t){r.dispose();return}clearTimeout(this.#s),this.#e=0,this.#o(r)}hurry(){this.#i!==void 0?this.open():this.engine?.stats().state==="lost"&&this.engine.hurry()}again(){if(this.engine===null)return void this.open();const{token:t}=this.tokens;t!==null&&this.engine.setToken(t),this.engine.reconnect()}#o(t){this.engine=t,t.on("state",(e,n)=>{e==="lost"?this.#c({kind:"away",text:n,retryAt:null}):e==="refused"?this.#c(Hh(n)?{kind:"token",text:n}:{kind:"refused",text:n}):e!=="connecting"&&this.#c(null)}),t.on("world",e=>this.#u(e)),t.on("contextLost",()=>{this.#c({kind:"graphics-lost"}),this.#s=setTimeout(()=>void this.open(),kM)}),t.on("contextRestored",()=>{clearTimeout(this.#s),this.#c(null)}),this.listener.opened(t,this.#a),this.#a=!0,this.#c(null),this.#u(t.world)}#u(t){const e=this.#r!==null&&this.#r!==t.fingerprint;this.#r=t.fingerprint,e&&this.listener.worldChanged(t)}async#h(t){const e=await this.server.obstacle();t!==this.#t||this.engine!==null||(e?.kind==="away"?this.#c({kind:"away",text:e.text,retryAt:null}):this.settings.transport==="websocket"&&++this.#n>1&&this.#c({kind:"no-socket",text:"The server answers, but its WebSocket does not open."}),this.#s=setTimeout(()=>void this.#h(t),zh))}async#d(t,e){if(clearTimeout(this.#s),document.createElement("canvas").getContext("webgl2")===null)return this.#c({kind:"no-webgl",text:e});const n=await this.server.obstacle();t===this.#t&&this.#f(n??{kind:Hh(e)?"token":"away",text:e})}#f({kind:t,text:e}){if(t==="token"||t==="no-world")return this.#c({kind:t,text:e});if(t!=="away")return this.#c({kind:"refused",text:e});const n=Math.min(OM,FM*2**this.#e++);this.#i=setTimeout(()=>void this.open(),n),this.#c({kind:t,text:e,retryAt:performance.now()+n})}#c(t){this.listener.trouble(t)}#l(){clearTimeout(this.#i),clearTimeout(this.#s),this.#i=void 0,this.engine!==null&&(this.listener.closing(),this.engine.dispose(),this.engine=null)}}const Gh={KeyW:["forward",1],KeyS:["forward",-1],KeyD:["right",1],KeyA:["right",-1],Space:["up",1],KeyC:["up",-1],ArrowUp:["forward",1],ArrowDown:["forward",-1],ArrowRight:["turn",1],ArrowLeft:["turn",-1],KeyE:["turn",1],KeyQ:["turn",-1],PageUp:["tilt",1],PageDown:["tilt",-1]};function zM(i,t){return i instanceof HTMLElement?i.isContentEditable||/^(INPUT|SELECT|TEXTAREA)$/.test(i.tagName)?t!=="Escape":/^(BUTTON|A|SUMMARY)$/.test(i.tagName)&&(t==="Space"||t==="Enter"):!1}class HM{#t=new Set;constructor(t,e){addEventListener("keydown",n=>{if(!(n.ctrlKey||n.altKey||n.metaKey||zM(n.target,n.code))&&!e()){if(n.code in Gh)this.#t.add(n.code),n.preventDefault();else if(n.key==="Shift")this.#t.add("Shift");else if(!n.repeat){const s=t[n.code]??t[n.key];if(s===void 0)return;n.preventDefault(),s()}}}),addEventListener("keyup",n=>this.#t.delete(n.key==="Shift"?"Shift":n.code))}read(t){for(const e of this.#t){const n=Gh[e];n!==void 0&&(t[n[0]]+=n[1])}for(const e of["forward","right","up","turn","tilt"])t[e]=Math.max(-1,Math.min(1,t[e]));this.#t.has("Shift")&&(t.fast=!0)}release(){this.#t.clear()}}const GM=4;class VM{constructor(t,e,n,s,r){this.canvas=t,this.settings=e,t.addEventListener("pointerdown",o=>{if(o.pointerType!=="mouse")return;const a=o.button===2&&r();o.button!==0&&!a||(this.isLocked?n(t.clientWidth/2,t.clientHeight/2,a):a?n(o.clientX,o.clientY,!0):this.#n={x:o.clientX,y:o.clientY,moved:!1})}),addEventListener("pointermove",o=>{o.pointerType==="mouse"&&(!this.isLocked&&this.#n===null||this.#n!==null&&(Math.hypot(o.clientX-this.#n.x,o.clientY-this.#n.y)>GM&&(this.#n.moved=!0),!this.#n.moved)||this.#i(o.movementX,o.movementY))}),addEventListener("pointerup",o=>{if(o.pointerType!=="mouse"||this.#n===null)return;const a=!this.#n.moved;if(this.#n=null,!a)return;const l=()=>n(o.clientX,o.clientY,!1);if(r())return this.#s(l);l(),this.#s()}),t.addEventListener("contextmenu",o=>{r()&&o.preventDefault()}),t.addEventListener("wheel",o=>{o.preventDefault(),s(-Math.sign(o.deltaY||o.deltaX),o.shiftKey)},{passive:!1})}#t=0;#e=0;#n=null;get isLocked(){return document.pointerLockElement===this.canvas}read(t){t.yaw+=this.#t,t.pitch+=this.#e,this.#t=this.#e=0}release(){this.#n=null,this.#t=this.#e=0}#i(t,e){const n=this.settings.sensitivity;this.#t+=t*n,this.#e-=e*n*(this.settings.invertLook?-1:1)}#s(t=()=>{}){this.canvas.requestPointerLock()?.catch(t)}}const Md=1e-4,mi=i=>Math.floor(i+Md),gi=i=>Math.ceil(i-Md)-1;function Vh(i,t){for(let e=mi(i.low[1]);e<=gi(i.high[1]);++e)for(let n=mi(i.low[2]);n<=gi(i.high[2]);++n)for(let s=mi(i.low[0]);s<=gi(i.high[0]);++s)if(t(s,e,n))return!0;return!1}function WM(i,t,e,n){if(e===0)return 0;const[s,r]=t===0?[1,2]:t===1?[0,2]:[0,1],o=[0,0,0],a=l=>{for(o[t]=l,o[s]=mi(i.low[s]);o[s]<=gi(i.high[s]);++o[s])for(o[r]=mi(i.low[r]);o[r]<=gi(i.high[r]);++o[r])if(n(o[0],o[1],o[2]))return!0;return!1};if(e>0){const l=i.high[t];for(let c=gi(l)+1;c<=gi(l+e);++c)if(a(c))return Math.max(0,c-l)}else{const l=i.low[t];for(let c=mi(l)-1;c>=mi(l+e);--c)if(a(c))return Math.min(0,c+1-l)}return e}const ur=.3,XM=1.8,Wh=1.62,qM=5,$M=9,Xh=3.2,YM=27,qh=8.6,KM=1.02,ZM=120,JM=80,QM=1/60,Ka={slowest:2,usual:24,fastest:600},ds=Math.PI/180,dr=(i,t,e)=>i+(t-i)*e;class jM{constructor(t){this.stuffAt=t}position=[0,0,0];velocity=[0,0,0];yaw=0;pitch=0;mode="fly";flySpeed=Ka.usual;onGround=!1;swimming=!1;waiting=!1;#t=0;get eye(){return[this.position[0],this.position[1]+Wh-this.#t,this.position[2]]}place(t,e,n){this.position[0]=t,this.position[1]=e,this.position[2]=n,this.velocity.fill(0),this.#t=0}step(t,e){if(this.yaw=((this.yaw+e.yaw+e.turn*ZM*t)%360+360)%360,this.pitch=Math.min(89.9,Math.max(-89.9,this.pitch+e.pitch+e.tilt*JM*t)),this.mode==="fly")return this.#n(t,e);const n=Math.max(1,Math.ceil(t/QM));for(let s=0;s<n;++s)this.#i(t/n,e)}isIn(t,e){const{low:n,high:s}=this.#u(),r=(o,a,l)=>a<s[o]&&n[o]<l+1;return r(0,t.x,e.x)&&r(1,t.y,e.y)&&r(2,t.z,e.z)}get isBuried(){const[t,e,n]=this.eye;return this.#d("unknown",t,e,n)?void 0:this.#d("solid",t,e,n)}get speed(){return Math.hypot(...this.velocity)}rise(t){const e=this.position[1];for(let n=0;n<=t;++n)if(this.position[1]=n===0?e:Math.floor(e)+n,!Vh(this.#u(),this.#h))return!0;return this.position[1]=e,!1}#e(t){const[e,n]=[Math.sin(this.yaw*ds),Math.cos(this.yaw*ds)],s=e*t.forward+n*t.right,r=-n*t.forward+e*t.right,o=Math.max(1,Math.hypot(s,r));return{x:s/o,z:r/o}}#n(t,e){const n=this.flySpeed*(e.fast?4:1),s=Math.cos(this.pitch*ds),r=this.#e({...e,forward:e.forward*s}),o=Math.sin(this.pitch*ds)*e.forward+e.up,a=[r.x*n,Math.max(-1,Math.min(1,o))*n,r.z*n],l=1-Math.exp(-t*9);for(const c of[0,1,2]){const h=dr(this.velocity[c],a[c],l);this.velocity[c]=Math.abs(h)<.001?0:h,this.position[c]+=this.velocity[c]*t}this.onGround=this.swimming=this.waiting=!1,this.#t=0}#i(t,e){if(this.#t*=Math.exp(-t*14),this.waiting=this.#f(),this.waiting){this.velocity.fill(0);return}if(Vh(this.#u(),this.#h)&&!this.rise(64)){this.velocity.fill(0);return}const[n,s,r]=this.position;this.swimming=this.#d("liquid",n,s+.9,r);const o=this.swimming||this.#d("liquid",n,s+.3,r),a=this.#e(e),l=this.swimming?Xh*(e.fast?1.6:1):e.fast?$M:qM,c=1-Math.exp(-t*(this.swimming?5:this.onGround?16:4));this.velocity[0]=dr(this.velocity[0],a.x*l,c),this.velocity[2]=dr(this.velocity[2],a.z*l,c),this.swimming?this.#s(t,e):(this.velocity[1]=Math.max(-55,this.velocity[1]-YM*t),e.up>0&&this.onGround?this.velocity[1]=qh:e.up>0&&o&&this.velocity[1]<3&&(this.velocity[1]=3)),this.#r(t,o,e)}#s(t,e){const n=e.forward>0?Math.sin(this.pitch*ds)*e.forward:0,r=Math.max(-1,Math.min(1,e.up+n))*Xh+(e.up===0?-.6:0);this.velocity[1]=dr(this.velocity[1],r,1-Math.exp(-t*5))}#r(t,e,n){const s=this.velocity[1]*t,r=this.#o(1,s),o=this.onGround;this.onGround=s<0&&r>s,r!==s&&(this.velocity[1]=0);for(const a of[0,2]){const l=this.velocity[a]*t,c=this.#o(a,l);c!==l&&((this.onGround||o)&&this.#a(a,l-c)||(this.velocity[a]=0,e&&n.up>0&&(this.velocity[1]=qh)))}}#a(t,e){const n=[...this.position],s=this.#o(1,KM),r=this.#o(t,e);this.#o(1,-s);const o=this.position[1]-n[1];if(Math.abs(r)<Math.abs(e)*.5||o<.01||this.#f()){for(const a of[0,1,2])this.position[a]=n[a];return!1}return this.#t+=o,this.onGround=!0,this.velocity[1]<0&&(this.velocity[1]=0),!0}#o(t,e){const n=WM(this.#u(),t,e,this.#h);return this.position[t]+=n,n}#u(){const[t,e,n]=this.position;return{low:[t-ur,e,n-ur],high:[t+ur,e+XM,n+ur]}}#h=(t,e,n)=>{const s=this.stuffAt(t,e,n);return s==="solid"||s==="unknown"};#d(t,e,n,s){return this.stuffAt(Math.floor(e),Math.floor(n),Math.floor(s))===t}#f(){const[t,e,n]=this.position;return this.#d("unknown",t,e,n)||this.#d("unknown",t,e+Wh,n)||this.#d("unknown",t,e-.5,n)}}const tw=()=>({forward:0,right:0,up:0,turn:0,tilt:0,yaw:0,pitch:0,fast:!1}),$h=Math.PI/180;class ew{body=new jM((t,e,n)=>this.stuffAt(t,e,n));#t=[];#e=null;hasMoved=!1;add(t){this.#t.push(t)}enter(t){this.#e=t}step(t){const e=tw();for(const n of this.#t)n.read(e);this.hasMoved||=e.forward!==0||e.right!==0||e.up!==0||e.turn!==0||e.tilt!==0||e.yaw!==0,this.body.step(t,e)}release(){for(const t of this.#t)t.release()}look(t){const[e,n,s]=this.body.eye;t.setCamera(e,n,s,this.body.yaw*$h,this.body.pitch*$h)}toggleMode(){const{body:t}=this;t.mode=t.mode==="walk"?"fly":"walk",t.velocity.fill(0)}changeSpeed(t){const e=this.body.flySpeed*1.25**t;this.body.flySpeed=Math.min(Ka.fastest,Math.max(Ka.slowest,e))}stuffAt(t,e,n){const s=this.#e;if(s===null)return"unknown";const r=s.voxelAt(t,e,n);return r===void 0?e<s.world.minY?"solid":"unknown":s.isSolid(r)?"solid":s.isLiquid(r)?"liquid":"gas"}}const Go=56,nw=250,Vo=8,iw=2;class sw{constructor(t,e,n,s,r){this.canvas=t,this.stick=e,this.settings=n,this.onPick=s,this.onFirst=r,t.addEventListener("pointerdown",o=>this.#s(o)),t.addEventListener("pointermove",o=>this.#r(o)),t.addEventListener("pointerup",o=>this.#a(o,!0)),t.addEventListener("pointercancel",o=>this.#a(o,!1))}#t=new Map;#e=0;#n=0;up=0;hold(t,e){const n=s=>r=>{r.preventDefault(),this.up=s};t.addEventListener("pointerdown",n(e));for(const s of["pointerup","pointercancel","pointerleave"])t.addEventListener(s,n(0))}read(t){const e=this.#i();if(e!==void 0){const[n,s]=[e.atX-e.x,e.atY-e.y],r=Math.hypot(n,s),o=Math.min(1,Math.max(0,r-Vo)/(Go-Vo));o>0&&(t.right+=n/r*o,t.forward-=s/r*o,r>Go*1.6&&(t.fast=!0))}t.up+=this.up,t.yaw+=this.#e,t.pitch+=this.#n,this.#e=this.#n=0}release(){this.#t.clear(),this.up=this.#e=this.#n=0,this.#o()}#i(){return[...this.#t.values()].find(t=>t.moves)}#s(t){if(t.pointerType==="mouse")return;this.onFirst(),this.canvas.setPointerCapture(t.pointerId);const e=t.clientX<innerWidth/2&&this.#i()===void 0,{clientX:n,clientY:s,timeStamp:r}=t;this.#t.set(t.pointerId,{x:n,y:s,began:r,moves:e,atX:n,atY:s,strayed:!1}),this.#o()}#r(t){const e=this.#t.get(t.pointerId);if(e!==void 0){if(!e.moves){const n=this.settings.sensitivity*iw;this.#e+=(t.clientX-e.atX)*n,this.#n-=(t.clientY-e.atY)*n*(this.settings.invertLook?-1:1)}e.atX=t.clientX,e.atY=t.clientY,Math.hypot(e.atX-e.x,e.atY-e.y)>Vo&&(e.strayed=!0),this.#o()}}#a(t,e){const n=this.#t.get(t.pointerId);this.#t.delete(t.pointerId)&&(e&&n!==void 0&&!n.strayed&&t.timeStamp-n.began<nw&&this.onPick(n.x,n.y),this.#o())}#o(){const t=this.#i();if(this.stick.hidden=t===void 0,t===void 0)return;const[e,n]=[t.atX-t.x,t.atY-t.y],s=Math.max(1,Math.hypot(e,n)/Go);this.stick.style.transform=`translate(${t.x}px, ${t.y}px)`,this.stick.firstElementChild.style.transform=`translate(${e/s}px, ${n/s}px)`}}const rw=200,ow=64,aw=256;class lw{#t=[];get isEmpty(){return this.#t.length===0}push(t){const e={made:t};return this.#t.push(e),this.#t.length>rw&&this.#t.shift(),e}remove(t){this.#t=this.#t.filter(e=>e!==t)}pop(){return this.#t.pop()}clear(){this.#t=[]}}function cw(i,t){const e=t>0?Math.floor(t/2):1/0;return Math.max(1,Math.min(Math.floor((i-aw)/ow),e))}function hw(i,t){const e=[];for(let n=0;n<i.length;n+=t){const s=i.slice(n,n+t),r={guards:s.map(({voxel:o,after:a})=>({voxel:o,material:a})),writes:s.map(({voxel:o,before:a})=>({voxel:o,material:a}))};e.push({edit:r,made:s})}return e}const gn=0,Yh=4096,wd=({x:i,y:t,z:e})=>({x:i,y:t,z:e});function uw({x:i,y:t,z:e,normal:n}){return n.x===0&&n.y===0&&n.z===0?null:{x:i+n.x,y:t+n.y,z:e+n.z}}function Wo(i,t,e){return t==="dig"||e===gn?wd(i):uw(i)}function Xo(i,t){const e=n=>({x:n(i.x,t.x),y:n(i.y,t.y),z:n(i.z,t.z)});return{first:e(Math.min),last:e(Math.max)}}function yd({first:i,last:t}){return[t.x-i.x+1,t.y-i.y+1,t.z-i.z+1]}function Kh(i){return yd(i).reduce((t,e)=>t*e,1)}function dw({first:i,last:t},e){for(let n=i.y;n<=t.y;++n)for(let s=i.z;s<=t.z;++s)for(let r=i.x;r<=t.x;++r)e({x:r,y:n,z:s})}const qo=40,fw=12,Zh=256,Jh=16751978,Qh=16733512,pw=({x:i,y:t,z:e})=>`${i}, ${t}, ${e}`,Za=i=>i.charAt(0).toUpperCase()+i.slice(1)+(/[.!?]$/.test(i)?"":"."),mw=i=>/no right to edit/.test(i)?"This server lets only invited players build.":Za(`You may look, but not dig and build here: ${i}`);class gw{constructor(t,e){this.body=t,this.listener=e}isOn=!1;tool="dig";material=gn;palette=[];waiting=0;#t=null;#e=null;#n=null;#i=null;#s="";#r=new lw;enter(t){if(this.#t=t,this.#r.clear(),this.waiting=0,this.isOn&&this.#o(),t===null)return;const e=({id:n,phase:s})=>n===gn?0:s==="solid"?1:2;this.palette=t.world.materials.filter(({id:n,phase:s})=>n===gn||s!=="gas").sort((n,s)=>e(n)-e(s)||n.id-s.id),(!this.palette.some(({id:n})=>n===this.material)||this.material===gn)&&(this.material=this.palette[1]?.id??gn),this.ask()}get whyNot(){return this.#a??this.#n}get#a(){return this.#t===null?"The world is not here yet.":this.#t.whyNoEdits}async ask(){const t=this.#t;this.#n=null;let e=this.#a;if(t!==null&&e===null)try{const n=await t.editLimits();t===this.#t&&(this.#e=n)}catch(n){const{kind:s,message:r}=n;e=s==="refused"?mw(r.replace(/^the server says: /,"")):Za(r),t===this.#t&&s==="refused"&&(this.#n=e)}return t===this.#t&&this.listener.changed(),e}async toggle(){if(this.isOn)return this.#o();const t=this.#t,e=await this.ask();if(!(t!==this.#t||this.isOn)){if(e!==null)return this.#l(e,!0);this.isOn=!0,this.listener.changed()}}#o(){this.isOn=!1,this.#i=null,this.#t?.setMarker(null),this.listener.changed()}cancel(){const t=this.#i!==null;return this.#i=null,t}choose(t){this.tool=t,this.#i=null,this.listener.changed()}nextTool(){const t=["dig","build","fill"];this.choose(t[(t.indexOf(this.tool)+1)%t.length])}chooseMaterial(t){this.palette.some(e=>e.id===t)&&(this.material=t,this.tool==="dig"&&t!==gn&&(this.tool="build"),this.listener.changed())}chooseSwatch(t){const e=this.palette[t];e!==void 0&&this.chooseMaterial(e.id)}turn(t){const{length:e}=this.palette,n=this.palette.findIndex(({id:s})=>s===this.material);e>0&&this.chooseSwatch(((n+t)%e+e)%e)}sample(t,e){const n=this.#t?.raycast(t,e,qo,!0);n&&this.chooseMaterial(n.material)}look(t,e){if(!this.isOn||this.#t===null)return;const n=this.#t.raycast(t,e,qo),s=n&&Wo(n,this.tool,this.material);this.#t.setMarker(s===null?null:this.#u(s))}#u(t){const e=this.tool==="dig"||this.material===gn,n=Xo(this.tool==="fill"?this.#i??t:t,t),s=Kh(n)<=this.#h&&(e||!this.body.isIn(n.first,n.last)),r=e?Jh:this.palette.find(({id:o})=>o===this.material)?.colour??16777215;return s?{...n,colour:r,edge:e?Jh:16777215,veil:e?.14:.55}:{...n,colour:Qh,edge:Qh,veil:.3}}get#h(){const{voxels:t=0}=this.#e??{};return t>0?Math.min(t,Yh):Yh}act(t,e,n=!1){const s=this.#t;if(!this.isOn||s===null)return;if(this.body.speed>fw)return this.#l("Slow down to dig and build.",!0);if(this.waiting>=Zh)return this.#l("Much waits for the server already.",!0);const r=s.raycast(t,e,qo);if(r===null)return this.#l("Nothing is near enough there.",!1);const o=n?this.tool==="dig"?"build":"dig":this.tool;if(o==="fill")return this.#d(s,r);const a=Wo(r,o,this.material);a!==null&&this.#f(s,Xo(a,a),o==="dig"?gn:this.material)}#d(t,e){const n=Wo(e,"fill",this.material);if(n===null)return;if(this.#i===null)return this.#i=wd(n),this.#l(`From ${pw(n)}: now the other corner.`,!1);const s=Xo(this.#i,n);if(Kh(s)>this.#h)return this.#l(`${yd(s).join(" × ")} voxels are too many: at most ${this.#h} at once.`,!0);this.#f(t,s,this.material)&&(this.#i=null)}#f(t,e,n){if(n!==gn&&this.body.isIn(e.first,e.last))return this.#l("You stand there yourself.",!0),!1;const s=[];let r=!0;if(dw(e,l=>{const c=t.voxelAt(l.x,l.y,l.z);c===void 0?r=!1:c!==n&&s.push({voxel:l,before:c,after:n})}),!r)return this.#l("The land there is not here yet.",!0),!1;if(s.length===0)return!0;const o=this.#r.push(s),a=s.length===1?{guards:s.map(({voxel:l,before:c})=>({voxel:l,material:c})),writes:[{voxel:s[0].voxel,material:n}]}:{fills:[{...e,material:n}]};return this.#c(t,a,s.map(({voxel:l})=>({...l,material:n})),(l,c)=>{this.#r.remove(o),this.listener.changed(),this.#l(l==="conflict"?"Somebody changed that before you: it is as they left it.":c,!0)}),this.listener.changed(),!0}undo(){const t=this.#t;if(!this.isOn||t===null||this.waiting>=Zh)return;const e=this.#r.pop();if(this.listener.changed(),e===void 0)return this.#l("Nothing of yours is left to undo.",!1);const n=e.made.filter(({voxel:o,after:a})=>t.voxelAt(o.x,o.y,o.z)===a),s=e.made.length-n.length;if(n.length===0)return this.#l("Not undone: somebody has changed it since.",!0);if(n.some(({voxel:o,before:a})=>t.isSolid(a)&&this.body.isIn(o,o)))return this.#r.push(e.made),this.#l("You stand where it would come back: step aside.",!0);s>0&&this.#l(`Undone but for ${s} ${s===1?"voxel":"voxels"} that somebody has changed since.`,!0);const r=cw(t.world.limits.frameBytes,this.#e?.voxels??0);for(const{edit:o,made:a}of hw(n,r)){const l=a.map(({voxel:c,before:h})=>({...c,material:h}));this.#c(t,o,l,(c,h)=>{this.#l(c==="conflict"?"Not undone: somebody has changed it since.":h,!0)})}}get canUndo(){return!this.#r.isEmpty}#c(t,e,n,s){++this.waiting,t.edit(e,n).catch(r=>{t===this.#t&&(s(r.kind,Za(r.message.replace(/^the server says: /,""))),r.kind==="refused"&&this.ask().then(o=>o!==null&&t===this.#t&&this.isOn&&this.#o()))}).finally(()=>{t===this.#t&&--this.waiting})}#l(t,e){this.#s=t,this.listener.say(t,e)}get said(){return this.#s}}const _w=4e3,jh=9;class vw{constructor(t){this.giveBackFocus=t}#t=dt("edit-bar");#e=dt("edit-said");#n=dt("edit-palette");#i=dt("edit-undo");#s=dt("edit-waiting");#r=[...document.querySelectorAll("[data-edit-tool]")];#a=[dt("edit-open"),dt("thumb-edit")];#o;#u=null;#h;attach(t){this.#o=t;const e=(n,s)=>n.addEventListener("click",()=>{s(),this.giveBackFocus()});for(const n of this.#a)e(n,()=>void t.toggle());e(dt("edit-close"),()=>void t.toggle());for(const n of this.#r)e(n,()=>t.choose(n.dataset.editTool));e(this.#i,()=>t.undo()),e(this.#n,()=>{}),this.#n.addEventListener("click",({target:n})=>{const s=n.closest("[data-material]");s!==null&&t.chooseMaterial(Number(s.dataset.material))}),this.show()}show(){const{isOn:t,tool:e,material:n,palette:s,whyNot:r,canUndo:o}=this.#o;this.#t.hidden=!t,document.body.classList.toggle("editing",t);for(const a of this.#a)a.setAttribute("aria-pressed",String(t)),a.setAttribute("aria-disabled",String(r!==null)),a.title=r??"";for(const a of this.#r)a.setAttribute("aria-pressed",String(a.dataset.editTool===e));this.#i.disabled=!o,this.#u!==s&&(this.#u=s,this.#n.replaceChildren(...s.map(({id:a,name:l,colour:c},h)=>{const d=Ke("button");d.type="button",d.dataset.material=String(a),d.setAttribute("aria-label",h<jh?`${l}, key ${h+1}`:l),d.title=l;const u=Ke("i");return a!==0?u.style.background="#"+c.toString(16).padStart(6,"0"):u.className="air",d.append(u),h<jh&&d.append(Ke("span",String(h+1))),d})));for(const a of this.#n.children){const l=a.dataset.material===String(n);a.setAttribute("aria-pressed",String(l)),l&&t&&a.scrollIntoView({block:"nearest",inline:"nearest"})}ee(dt("edit-material"),s.find(({id:a})=>a===n)?.name??"")}say(t,e){ee(this.#e,t),this.#e.classList.toggle("bad",e),this.#e.hidden=t==="",clearTimeout(this.#h),this.#h=setTimeout(()=>this.#e.hidden=!0,_w)}waits(t){this.#s.hidden=t===0,t>0&&ee(this.#s,`${t} ${t===1?"edit waits":"edits wait"} for the server`)}}function xw(i,{eye:t,ahead:e}){const n=r=>()=>{i.isOn&&r()},s={KeyV:()=>void i.toggle(),KeyR:n(()=>i.nextTool()),KeyZ:n(()=>i.undo()),KeyI:n(()=>i.sample(t(),e())),KeyJ:n(()=>i.turn(-1)),KeyL:n(()=>i.turn(1)),Backspace:n(()=>i.act(t(),e(),i.tool!=="dig"))};for(let r=1;r<=9;++r)s[`Digit${r}`]=n(()=>i.chooseSwatch(r-1));return s}function Sw(i,t){addEventListener("keydown",e=>{const n=e.target instanceof HTMLElement&&/^(INPUT|TEXTAREA|SELECT)$/.test(e.target.tagName);e.code!=="KeyZ"||!(e.ctrlKey||e.metaKey)||e.shiftKey||n||!i.isOn||t()||(e.preventDefault(),i.undo())})}const Mw=.25,tu=20;class ww{constructor(t){this.turns=t}#t=0;#e=0;#n=0;#i=[];start(){const t=e=>{requestAnimationFrame(t),this.turns.step(e,Math.min(Mw,Math.max(0,(e-this.#t)/1e3))),this.#t=e,this.#s();const n=this.turns.cap();n>0&&e-this.#e<1e3/n-1||(this.#e=e,this.#i.push(e),this.#i.length>60&&this.#i.shift(),this.turns.draw(e))};requestAnimationFrame(t),setInterval(()=>{performance.now()-this.#n>=tu&&this.#s()},tu)}#s(){this.turns.update(),this.#n=performance.now()}get framesPerSecond(){const[t,e]=[this.#i[0],this.#i.at(-1)];return t===void 0||e===void 0||e===t?0:(this.#i.length-1)*1e3/(e-t)}}const yw=500,Ew=10;class bw{#t=0;#e=0;#n="";#i="";follow(t,e){if(t-this.#t<yw)return;this.#t=t;const n=tc(e,location.hash),s=n===this.#n;this.#n=n,n!==this.#i&&(s||++this.#e>=Ew)&&this.#s(n)}write(t){this.#s(tc(t,location.hash))}#s(t){this.#e=0,t!==this.#i&&(this.#i=t,history.replaceState(history.state,"",t))}}const Tw=600,Aw=2,eu=4;function Rw({memory:i,isCoarse:t,shortSide:e}){return i!==null&&i<=Aw?{radius:6,horizon:2048}:t&&(e<Tw||i===null||i<=eu)||i!==null&&i<=eu?{radius:10,horizon:4096}:null}function Ed(i,t){if(t===null)return i;const e={...i};for(const n of["radius","horizon"])e[n]!==void 0&&(e[n]=Math.min(e[n],t[n]));return e}function Cw(){const{deviceMemory:i}=navigator;return{memory:i??null,isCoarse:matchMedia("(pointer: coarse)").matches,shortSide:Math.min(screen.width,screen.height)}}const nu=(...i)=>t=>i.includes(t),fr=(i,t)=>e=>typeof e=="number"&&e>=i&&e<=t,pr=i=>typeof i=="boolean",Ja={radius:fr(2,24),horizon:fr(0,16384),quality:nu("low","high"),transport:nu("websocket","http"),frameRate:fr(0,240),sensitivity:fr(.02,1),invertLook:pr,timeRuns:pr,chunkBorders:pr,reducedMotion:i=>i===null||pr(i)};function bd(i){return{radius:i?6:10,horizon:i?2048:4096,quality:i?"low":"high",transport:"websocket",frameRate:0,sensitivity:.12,invertLook:!1,timeRuns:!1,chunkBorders:!1,reducedMotion:null}}function Il(i,t){const e={...i};if(typeof t=="object"&&t!==null)for(const[n,s]of Object.entries(t))n in Ja&&Ja[n](s)&&(e[n]=s);return e}function Pw(i){const t={};for(const[e,n]of new URLSearchParams(i.replace(/^#/,"")))e in Ja&&(t[e]=n==="true"?!0:n==="false"?!1:/^\d+(\.\d+)?$/.test(n)?Number(n):n);return t}const Td="talus.settings";function Lw(i,t){try{return Il(i,JSON.parse(t().getItem(Td)??"null"))}catch{return i}}function Iw(i,t){try{t().setItem(Td,JSON.stringify(i))}catch{}}const Dw=14,Nw=16;class Uw{constructor(t,e,n){this.body=t,this.server=e,this.engine=n}isPlaced=!1;#t=!1;#e=!1;#n=null;place(t){const[e,n,s]=this.body.position,{yaw:r,pitch:o,mode:a}=this.body;return{x:e,y:n,z:s,yaw:r,pitch:o,time:t,mode:a}}async to(t,e,n){this.#s(t,e??await this.#i(t,n),n,e===null)}async#i(t,e){return Math.max(await this.server.ground(t,e),this.engine()?.world.seaLevel??-1/0)+this.#a}#s(t,e,n,s){this.body.place(t,e,n),this.#t=s,this.#e=!s,this.isPlaced=!0}toSpawn(){const t=this.engine();if(t===null)return;const{x:e,y:n,z:s}=t.world.spawn;this.body.place(e+.5,n+this.#a,s+.5),this.#t=this.#e=!1,this.#n=null,this.isPlaced=!0}async lookOut(){const t=this.place(0);let e=t.yaw;try{e=await this.server.outlook(t.x,t.z)}catch{}this.#r(t)&&(this.body.yaw=e,this.#n=this.place(0))}turnFromWhatIsNear(t){const e=this.#n;if(e!==null){if(this.#r(e)){const n=(r,o,a)=>t.voxelAt(r,o,a),s=cf(this.body.eye,e.yaw,e.pitch,n,r=>t.isSolid(r));if(s===void 0)return;this.body.yaw=s}this.#n=null}}#r(t){const e=this.place(0);return["x","y","z","yaw","pitch"].every(n=>e[n]===t[n])}surface(t){if(!this.#t)return;const[e,n,s]=this.body.position,r=a=>t.voxelAt(Math.floor(e),a,Math.floor(s));let o=Math.floor(n);for(;t.isLiquid(r(o)??0);)++o;r(o)!==void 0&&(this.#t=!1,o>n&&this.body.place(e,o+this.#a,s))}emerge(){if(!this.#e)return;const{isBuried:t,position:e}=this.body;if(t===void 0||(this.#e=!1,!t||this.body.rise(Nw)))return;const[n,s,r]=e;this.#i(n,r).then(o=>{const a=this.body.position;a[0]===n&&a[1]===s&&a[2]===r&&this.#s(n,o,r,!0)}).catch(()=>{})}get#a(){return this.body.mode==="fly"?Dw:0}}const Fw=12e3;class Ow{#t=dt("hint");#e=!1;#n=null;constructor(t){dt("hint-close").addEventListener("click",()=>{this.#e=!0,this.#t.hidden=!0,t()})}tick(t,e,n){if(this.#e)return;const s=this.#t.matches(":hover, :focus-within");!e||s?this.#n=null:this.#n??=t,this.#e=n||this.#n!==null&&t-this.#n>Fw,this.#t.hidden!==this.#e&&(this.#t.hidden=this.#e)}}const fs=60,kw=new Intl.NumberFormat("en",{maximumFractionDigits:0}),on=i=>kw.format(Math.round(i));function mr(i){if(i<1e3)return`${Math.round(i)} B`;for(const t of["kB","MB","GB"])if(i/=1e3,i<1e3||t==="GB")return`${i<10?i.toFixed(2):i<100?i.toFixed(1):Math.round(i)} ${t}`;return""}const ps=i=>i<10?i.toFixed(1):String(Math.round(i)),Bw={connecting:"connecting",streaming:"streaming",complete:"complete",lost:"server away",refused:"refused"};class zw{constructor(t){this.isHere=t}#t=new Map;#e=[];#n=0;#i=0;#s=0;update(t,e,n,s){const r=Math.floor(e/1e3);if(r!==this.#n&&(this.#n=r,this.#s=Math.max(0,t.receivedBytes-this.#i),this.#i=t.receivedBytes,this.#e.push(t.chunkRate),this.#e.length>fs&&this.#e.shift()),!s)return;const{latency:o,frameCpu:a}=t;this.#r("View",Bw[t.state]),this.#r("Chunks",`${on(t.chunks)}, ${on(t.chunkRate)} /s`),t.madeChunks>0&&this.#r("Made here",`${on(t.madeChunks)} chunks`),this.isHere||this.#r("By wire",`${on(t.receivedChunks)} chunks`),this.isHere||this.#r("Received",`${mr(t.receivedBytes)}, ${mr(this.#s)}/s`),this.#r("Asked to drawn, p50",o===null?"–":`${ps(o.p50)} ms`),this.#r("p95, p99",o===null?"–":`${ps(o.p95)}, ${ps(o.p99)} ms`),this.#r("Land is missing",t.nearestMissing===null?"nowhere":`${on(t.nearestMissing)} blocks away`),this.#r("Meshes, to come",`${on(t.meshes)}, ${on(t.pendingMeshes)}`),this.#r("Triangles",on(t.triangles)),this.#r("Draw calls",on(t.drawCalls)),this.#r("Pictures a second",n.toFixed(0)),this.#r("Frame, p50, p95",`${ps(a.p50)}, ${ps(a.p95)} ms`),this.#r("On the card, in the page",`${mr(t.gpuBytes)}, ${mr(t.heapBytes)}`),this.#a(),this.#o(t.chunksPerLevel)}#r(t,e){let n=this.#t.get(t);n===void 0&&(n=Ke("dd"),this.#t.set(t,n),dt("traffic").append(Ke("dt",t),n)),ee(n,e)}#a(){const t=Math.max(1,...this.#e),e=this.#e.map((s,r)=>`${(r+fs-this.#e.length)*(120/(fs-1))} ${30-s/t*28}`);if(e.length<2)return;const n=(fs-this.#e.length)*(120/(fs-1));dt("traffic-chart").querySelector(".line").setAttribute("d",`M${e.join("L")}`),dt("traffic-chart").querySelector(".area").setAttribute("d",`M${n} 32L${e.join("L")}L120 32z`)}#o(t){const e=dt("traffic-levels"),n=Math.max(1,...t);for(;e.childElementCount<t.length;){const s=Ke("li"),r=e.childElementCount;s.append(Ke("span",r===0?"Full detail":`1 : ${2**r}`),Ke("meter"),Ke("span")),e.append(s)}t.forEach((s,r)=>{const[o,a,l]=e.children[r].children;a.max=n,a.value=s,a.setAttribute("aria-label",`${o.textContent}: ${s} chunks`),ee(l,on(s))})}}function Ad(i){return i.state==="complete"?1:i.chunks===0?null:Math.min(.99,Math.max(0,i.chunks-i.pendingMeshes)/i.chunksWanted)}class Hw{constructor(t){this.isHere=t}#t=dt("opening");#e=dt("hint").querySelector(".to-mode");opening(t,e){ee(dt("opening-text"),t);const n=dt("opening-progress");e===null?n.removeAttribute("value"):n.value=e}opened(){this.#t.classList.add("gone"),dt("opening-progress").value=1,this.#t.removeAttribute("role")}status(t,e){ee(dt("status-text"),t);const n=dt("status");n.dataset.state!==e&&(n.dataset.state=e)}connection(t){if(t.state==="lost")return this.status("Server away","bad");if(t.state==="refused")return this.status("Refused","bad");if(t.state==="connecting")return this.status("Connecting","busy");if(t.state==="complete")return this.status("All here","good");const e=Ad(t),n=t.chunksWanted>0&&t.chunks>=t.chunksWanted?"Drawing":this.isHere?"Making":"Receiving";this.status(e===null?n:`${n} ${Math.floor(e*100)} %`,"busy")}where(t,e){const[n,s,r]=[t.x,t.y??0,t.z].map(Math.floor);ee(dt("where-at"),`${n}, ${s}, ${r}`);const o=e.waiting?"waiting for the land":e.mode==="fly"?`flying ${ec(t.yaw)}`:`${e.swimming?"swimming":"walking"} ${ec(t.yaw)}`;ee(dt("where-way"),o),ee(dt("where-speed"),e.mode==="fly"&&!e.waiting?`, ${on(e.flySpeed)} blocks/s`:""),ee(this.#e,e.mode==="fly"?"walk":"fly")}}function Gw(i){const t=()=>i.classList.toggle("more",i.scrollHeight-i.scrollTop-i.clientHeight>8);i.addEventListener("scroll",t,{passive:!0});const e=new ResizeObserver(t);e.observe(i);for(const n of i.children)e.observe(n)}class Vw{constructor(t){this.answers=t}#t=dt("notice");#e=dt("notice-text");#n=null;#i="";trouble(t){if(this.#n=null,t===null){["world","not-kept"].includes(this.#t.dataset.kind??"")||this.hide();return}switch(t.kind){case"away":this.#i=t.text,this.#n=t.retryAt,this.#s("away","The server is away","",[["Try now",this.answers.retry]]),this.tick(performance.now());break;case"token":this.#s("token","The server asks for a token",t.text,[["Give a token",()=>this.answers.askToken(t.text)]]),this.answers.askToken(t.text);break;case"refused":this.#s("refused","The server refuses",t.text,[["Try again",this.answers.again]]);break;case"no-world":this.#s("no-world","This link opens no world",t.text,[["Open the default world",this.answers.openDefault]]);break;case"no-socket":this.#s("no-socket","The land does not come",t.text,[["Take it by HTTP",this.answers.byHttp],["Try again",this.answers.reload]]);break;case"no-webgl":this.#s("no-webgl","This browser shows no 3D here",`${$o(t.text)} The map works without.`,[["Open the map",()=>location.assign("map.html"+location.hash)],["Try again",this.answers.reload]]);break;case"graphics-lost":this.#s("graphics-lost","The system took the graphics away","The picture comes back in a moment.",[["Now",this.answers.reload]])}}worldChanged(){this.#s("world","This is another world now","The server has a new one. You stand at the same coordinate in it.",[["Go to its spawn",()=>(this.answers.toSpawn(),this.hide())],["Stay",()=>this.hide()]])}notKept(t){this.#s("not-kept","This browser keeps no edits here",t,[["Play on",()=>this.hide()]])}hide(){this.#t.hidden=!0,delete this.#t.dataset.kind}tick(t){if(this.#t.dataset.kind!=="away")return;const e=this.#n===null?null:Math.max(0,Math.ceil((this.#n-t)/1e3)),n=e===null||e===0?"Trying again.":`Trying again in ${e} s.`,s=this.#i===""?"":$o(this.#i)+" ";ee(this.#e,s+n)}#s(t,e,n,s){this.#t.dataset.kind=t,ee(dt("notice-title"),e),ee(this.#e,n===""?"":$o(n)),dt("notice-actions").replaceChildren(...s.map(([r,o])=>{const a=Ke("button",r);return a.type="button",a.addEventListener("click",o),a})),this.#t.hidden=!1}}const $o=i=>i.charAt(0).toUpperCase()+i.slice(1)+(/[.!?]$/.test(i)?"":".");class Ww{constructor(t){this.giveBackFocus=t;for(const e of document.querySelectorAll("[data-panel]")){const n=e.dataset.panel;this.#e.set(n,e),e.setAttribute("aria-expanded","false"),e.setAttribute("aria-controls",`panel-${n}`),e.addEventListener("click",()=>this.toggle(n))}}#t=null;#e=new Map;onOpen=new Map;isOpen(t){return this.#t===t}get isAnyOpen(){return this.#t!==null}toggle(t,e=!0){const n=this.#t!==t;if(this.close(!1),!n)return this.giveBackFocus();this.#t=t;const s=dt(`panel-${t}`);s.hidden=!1,this.#e.get(t).setAttribute("aria-expanded","true"),document.exitPointerLock?.(),this.onOpen.get(t)?.(),e&&s.querySelector("input, button, select")?.focus({preventScroll:!0})}close(t=!0){return this.#t===null?!1:(dt(`panel-${this.#t}`).hidden=!0,this.#e.get(this.#t).setAttribute("aria-expanded","false"),this.#t=null,t&&this.giveBackFocus(),!0)}}const gr={radius:({radius:i})=>`${i} chunks`,horizon:({horizon:i})=>i===0?"none":`${(i/1e3).toFixed(1)} km`,sensitivity:({sensitivity:i})=>`${Math.round(i*100)}`};class Xw{constructor(t,e,n,s){this.settings=t,s!==null&&this.#e(s),this.#t.addEventListener("submit",r=>r.preventDefault()),this.#t.addEventListener("input",r=>{const o=r.target,a=o instanceof HTMLInputElement&&o.type==="checkbox"?String(o.checked):o.value,l=a==="null"?null:a==="true"?!0:a==="false"?!1:Number.isNaN(Number(a))?a:Number(a),c=Il(t,{[o.name]:l}),h=o.name;c[h]!==t[h]&&e({[h]:c[h]}),this.show()}),dt("settings-reset").addEventListener("click",()=>{e(bd(n)),this.show()}),this.show()}#t=dt("settings");#e(t){for(const r of["radius","horizon"])this.#t.elements.namedItem(r).max=String(t[r]);const e=dt("settings-cap");e.hidden=!1;const[n,s]=[gr.radius(t),gr.horizon(t)];ee(e,`On this device at most ${n} of full detail and a horizon of ${s}: more would take memory that it may not have.`)}show(){for(const[t,e]of Object.entries(this.settings)){const n=this.#t.elements.namedItem(t);n instanceof HTMLInputElement&&n.type==="checkbox"?n.checked=e:n instanceof HTMLInputElement?n.value=String(e):n instanceof HTMLSelectElement&&([...n.options].some(s=>s.value===String(e))||n.add(new Option(String(e))),n.value=String(e)),t in gr&&ee(dt(`${t}-now`),gr[t](this.settings))}}}class qw{constructor(t,e,n){this.picture=t,this.place=e,dt("save-picture").addEventListener("click",()=>void this.save()),dt("copy-link").addEventListener("click",async()=>{n();try{await navigator.clipboard.writeText(location.href),this.#t("The link is copied.")}catch{this.#t("This browser does not let the page copy; the address above is the link.")}})}async save(){const t=this.picture();if(t===null)return this.#t("There is no picture yet.");const e=URL.createObjectURL(await t),{x:n,z:s}=this.place(),r=document.createElement("a");r.href=e,r.download=`talus_${Math.round(n)}_${Math.round(s)}.png`,r.click(),URL.revokeObjectURL(e),this.#t(`Saved as ${r.download}.`)}#t(t){ee(dt("share-said"),t)}}const $w=4,Rd=256,Yw=96,Kw=i=>Math.round(Math.min(Rd,Math.max($w,i??Yw)));function iu(i,t){const e=i.yaw*Math.PI/180;return{x:i.x+Math.sin(e)*t,z:i.z-Math.cos(e)*t,yaw:e+Math.PI}}class Zw{constructor(t,e){this.standNow=t,this.apply=e,this.#t.addEventListener("change",()=>this.#t.checked?this.cutHere():this.#s()),this.#e.addEventListener("input",()=>this.#s()),this.#n.addEventListener("input",()=>{const{x:n,z:s}=iu(this.#i,Number(this.#e.value));this.#i={x:n,z:s,yaw:Number(this.#n.value)},this.#e.value="0",this.#s()}),dt("slice-here").addEventListener("click",()=>this.cutHere()),this.#s()}#t=dt("slice-on");#e=dt("slice-distance");#n=dt("slice-yaw");#i={x:0,z:0,yaw:0};get slice(){return this.#t.checked?iu(this.#i,Number(this.#e.value)):null}cutHere(){const{x:t,z:e,yaw:n,seen:s}=this.standNow();this.#i={x:t,z:e,yaw:Math.round(Vd(n))%360},this.#e.value=String(Kw(s)),this.#n.value=String(this.#i.yaw),this.#t.checked=!0,this.#s()}off(){this.#t.checked=!1,this.#s()}move(t){if(!this.#t.checked)return this.cutHere();this.#e.value=String(Number(this.#e.value)+t),this.#s()}#s(){ee(dt("slice-distance-now"),`${this.#e.value} blocks`),ee(dt("slice-yaw-now"),`${this.#n.value}°`),dt("slice-said").hidden=!this.#t.checked,this.apply(this.slice)}}const Jw=i=>i.charAt(0).toUpperCase()+i.slice(1);class Qw{constructor(t,e){t.onNotKept=e,dt("open-worlds").hidden=!1,document.body.classList.add("here"),dt("worlds-list").append(...t.names.map(s=>{const r=Ke("a",Jw(s));r.href=Ko(s,location.hash),s===t.name&&r.setAttribute("aria-current","true");const o=Ke("li");return o.append(r),o}));const n=dt("worlds-file");n.addEventListener("change",()=>void this.#t(n.files?.[0]))}async#t(t){if(t!==void 0){if(t.size>rc)return ee(dt("worlds-said"),`${t.name} has ${t.size} bytes; a world file has at most ${rc}.`);location.hash=Ko(await hf(new Uint8Array(await t.arrayBuffer())),location.hash)}}}const su=256,Cd=70,ms=Math.PI/180;function Dl(i,t,e,n){const s=Math.tan(Cd/2*ms),[r,o]=[Math.sin(i*ms),Math.cos(i*ms)],[a,l]=[Math.sin(t*ms),Math.cos(t*ms)],[c,h]=[e*s,n*s],d=l-h*a,[u,f,v]=[r*d+o*c,a+h*l,-o*d+r*c],S=Math.hypot(u,f,v);return{x:u/S,y:f/S,z:v/S}}class jw{#t=dt("voxel");#e=dt("voxel-close");#n=null;#i=null;constructor(){this.#e.addEventListener("click",()=>this.letGo())}get held(){return this.#n}get shown(){return this.#i}look(t,e,n,s){this.#n===null&&this.#s(t,t.raycast(e,Dl(n,s,0,0),su,!0))}hold(t,e,n){this.#n=t.raycast(e,n,su,!0),this.#e.hidden=this.#n===null,this.#s(t,this.#n)}letGo(){const t=this.#n!==null;return this.#n=null,this.#e.hidden=!0,t}clear(){this.letGo(),this.#i=null,this.#t.hidden=!0}#s(t,e){const n=e!==null&&this.#i!==null&&e.x===this.#i.x&&e.y===this.#i.y&&e.z===this.#i.z&&e.material===this.#i.material;if(!n&&(e!==null||this.#i!==null)&&t.setSelection(e),n||(this.#i=e,this.#t.hidden=e===null,e===null))return;const s=t.world.materials.find(({id:r})=>r===e.material);ee(dt("voxel-name"),s?.name??`material ${e.material}`),ee(dt("voxel-at"),`${e.x}, ${e.y}, ${e.z}`),dt("voxel-colour").style.background="#"+(s?.colour??0).toString(16).padStart(6,"0"),this.#t.dataset.material=String(e.material)}}const Pd=Cw(),Nl=Pd.isCoarse,Ul=Rw(Pd),Ld=matchMedia("(prefers-reduced-motion: reduce)"),Id=()=>localStorage,ty=1440,ey=-8;let Ar=Lw(bd(Nl),Id);const Ee=Ed(Il(Ar,Pw(location.hash)),Ul),Qa=()=>Ee.reducedMotion??Ld.matches,Fl=new Wd,Ls=await Xd(location.href,()=>Fl.token),Ji=Ls.source!==null,ny=du(location.hash),Fe=new ew,{body:he}=Fe,Ol=new bw,En=dt("stage");let Jt=null,Mn=sl(location.hash).time??10.5;const pe=new Uw(he,Ls,()=>Jt),qi=()=>pe.place(Mn);function Dd(i){he.mode=i.mode??he.mode,he.yaw=i.yaw??he.yaw,he.pitch=i.pitch??he.pitch,i.time!==void 0&&$i(i.time),i.x!==void 0&&i.z!==void 0?pe.to(i.x,i.y??null,i.z).catch(t=>{hn.status(t.message,"bad"),pe.isPlaced||pe.toSpawn()}):pe.isPlaced||(pe.toSpawn(),i.yaw===void 0&&pe.lookOut())}addEventListener("hashchange",()=>{du(location.hash)!==ny?location.reload():Dd(sl(location.hash))});addEventListener("pagehide",()=>{pe.isPlaced&&Ol.write(qi())});const ja=dt("time"),Wr=dt("time-runs");function $i(i){Mn=Yd(i),Jt?.setTimeOfDay(Mn),ja.value=String(Mn),ee(dt("time-now"),Kd(Mn))}ja.addEventListener("input",()=>$i(Math.min(23.99,Number(ja.value))));Wr.checked=Ee.timeRuns;Wr.addEventListener("change",()=>Is({timeRuns:Wr.checked}));function Is(i){const t=Ed(i,Ul);Object.assign(Ee,t),Ar={...Ar,...t},Iw(Ar,Id),"transport"in t&&vi.open(),("radius"in t||"horizon"in t)&&Jt?.setRadius(Ee.radius,Ee.horizon),"quality"in t&&(Jt?.setQuality(Ee.quality),zl()),"reducedMotion"in t&&jr(),"chunkBorders"in t&&kl(),Wr.checked=Ee.timeRuns}function jr(){Jt?.setReducedMotion(Qa()),document.body.classList.toggle("moves",!Qa())}Ld.addEventListener("change",jr);const tl=dt("borders");function kl(){tl.checked=Ee.chunkBorders,Jt?.setChunkBorders(Ee.chunkBorders)}tl.addEventListener("change",()=>Is({chunkBorders:tl.checked}));const Qi=()=>En.focus({preventScroll:!0}),vn=new Ww(Qi),hn=new Hw(Ji),iy=new Ow(Qi),sy=new zw(Ji),_i=new jw,Oi=new Zw(()=>({x:he.position[0],z:he.position[2],yaw:he.yaw,seen:oy()}),i=>Jt?.setSlice(i));new Xw(Ee,Is,Nl,Ul);new qw(()=>Jt?.screenshot()??null,qi,()=>Ol.write(qi()));const Nd=new qd(Fl,()=>{vi.again(),Ae.ask()});dt("token-change").addEventListener("click",()=>Nd.ask("The next connection uses it."));const Bl=dt("help");for(const i of document.querySelectorAll(".panel, #help, #notice"))Gw(i);const el=()=>{document.exitPointerLock?.(),Bl.showModal()};dt("open-help").addEventListener("click",el);Bl.addEventListener("close",Qi);dt("goto-form").addEventListener("submit",i=>{i.preventDefault();const t=$d(dt("goto-text").value),e=dt("goto-wrong");if(t===null)return ee(e,"Two or three numbers, such as 1200 -340 or 1200 90 -340.");ee(e,""),pe.to(t.x,t.y,t.z).then(()=>vn.close(),n=>ee(e,n.message))});dt("goto-spawn").addEventListener("click",()=>(pe.toSpawn(),vn.close()));const Xr=new vw(Qi),Ae=new gw(he,{changed:()=>Xr.show(),say:(i,t)=>Xr.say(i,t)});Xr.attach(Ae);const qr=new Vw({retry:()=>vi.hurry(),again:()=>vi.again(),reload:()=>void vi.open(),byHttp:()=>Is({transport:"http"}),askToken:i=>Nd.ask(i),toSpawn:()=>pe.toSpawn(),openDefault:()=>location.hash=Ko(null,location.hash)});Ji&&new Qw(Ls,i=>qr.notKept(i));const vi=new BM(En,Ee,Ls,Fl,Qa,{opened(i){Jt=i,document.body.classList.remove("empty"),Fe.enter(i),Ae.enter(i),i.setFov(Cd),zl(),i.setTimeOfDay(Mn),i.setSlice(Oi.slice),jr(),kl(),pe.isPlaced||Dd(ry()),hn.opening("The land is on its way",null),ee(dt("help-world"),`${Ji?"Made in this page":i.world.server}, world ${i.world.fingerprint}`)},closing(){Jt=null,document.body.classList.add("empty"),Fe.enter(null),Ae.enter(null),_i.clear()},trouble(i){if(qr.trouble(i),i===null)return;const t={away:"Server away",token:"No access",refused:"Refused","no-world":"No world","no-socket":"No connection","no-webgl":"No 3D","graphics-lost":"No graphics"};hn.status(t[i.kind],"bad"),i.kind==="away"?hn.opening("Waiting for the server",null):hn.opened()},worldChanged(i){_i.clear(),Ae.enter(Jt),ee(dt("help-world"),`${i.server}, world ${i.fingerprint}`),qr.worldChanged()}});function ry(){const i=sl(location.hash);return{pitch:ey,mode:"fly",...i}}function zl(){const i=Math.min(devicePixelRatio,Ee.quality==="high"?2:1);Jt?.resize(En.clientWidth,En.clientHeight,i)}addEventListener("resize",zl);const Yi=()=>{const[i,t,e]=he.eye;return{x:i,y:t,z:e}};function to(i,t,e=!1){if(Jt===null)return;const n=En.clientHeight/2,s=Dl(he.yaw,he.pitch,(i-En.clientWidth/2)/n,1-t/n);Ae.isOn?Ae.act(Yi(),s,e):_i.hold(Jt,Yi(),s)}function oy(){const i=Jt?.raycast(Yi(),Hl.ahead(),Rd,!0)??null;return i===null||i.distance===0?null:i.distance*Math.cos(he.pitch*Math.PI/180)}const ay=()=>to(En.clientWidth/2,En.clientHeight/2),Hl={eye:Yi,ahead:()=>Dl(he.yaw,he.pitch,0,0)},nl=i=>Fe.changeSpeed(i),ly=(i,t)=>Ae.isOn&&!t?Ae.turn(-i):nl(i),cy={...xw(Ae,Hl),KeyF:()=>Fe.toggleMode(),KeyM:()=>Fd(),KeyG:()=>vn.toggle("goto"),KeyT:()=>vn.toggle("time"),KeyX:()=>Oi.slice===null?Oi.cutHere():Oi.off(),BracketLeft:()=>Oi.move(-1),BracketRight:()=>Oi.move(1),KeyP:()=>vn.toggle("traffic",!1),KeyB:()=>Is({chunkBorders:!Ee.chunkBorders}),KeyK:()=>vn.toggle("share"),KeyO:()=>vn.toggle("settings"),KeyU:()=>document.body.classList.toggle("bare"),KeyH:el,"?":el,Home:()=>he.pitch=0,Comma:()=>$i(Mn-.25),Period:()=>$i(Mn+.25),"+":()=>nl(1),"-":()=>nl(-1),Enter:()=>Ae.isOn||_i.held===null?ay():_i.letGo(),Escape:()=>vn.close()||Ae.cancel()||_i.letGo()},Ud=()=>Bl.open||dt("token").open||!dt("map").hidden;Fe.add(new HM(cy,Ud));Sw(Ae,Ud);Fe.add(new VM(En,Ee,to,ly,()=>Ae.isOn));const Gl=new sw(En,dt("stick"),Ee,to,()=>{document.body.classList.add("touched"),dt("thumbs").hidden=!1});Gl.hold(dt("thumb-up"),1);Gl.hold(dt("thumb-down"),-1);dt("thumb-mode").addEventListener("click",()=>Fe.toggleMode());Fe.add(Gl);Nl&&(document.body.classList.add("touched"),dt("thumbs").hidden=!1);addEventListener("blur",()=>Fe.release());async function Fd(){document.exitPointerLock?.(),Fe.release();const{openMapOverlay:i}=await il(async()=>{const{openMapOverlay:t}=await import("./overlay-11xWCkbW.js");return{openMapOverlay:t}},__vite__mapDeps([9,10,11]),import.meta.url);i(dt("map"),Ls,{place:qi,world:()=>Jt?.world??null,go:(t,e)=>pe.to(t,null,e),closed:Qi})}dt("open-map").addEventListener("click",()=>void Fd());let ru=0,ou=0,Yo=!1;const Od=new ww({cap:()=>hy()?0:Ee.frameRate,step(i,t){Ee.timeRuns&&$i(Mn+t*24/ty),pe.isPlaced&&Fe.step(t),Jt!==null&&pe.isPlaced&&(pe.surface(Jt),pe.emerge(),pe.turnFromWhatIsNear(Jt),Fe.look(Jt),Ae.look(Yi(),Hl.ahead()),i-ou>100&&(ou=i,_i.look(Jt,Yi(),he.yaw,he.pitch)),Ol.follow(i,qi())),i-ru>250&&(ru=i,uy(i))},update(){Jt!==null&&pe.isPlaced&&Jt.update()},draw(i){Jt!==null&&pe.isPlaced&&Jt.frame(i)}});function hy(){if(Yo||Jt===null)return!1;const i=Jt.stats();return Yo=i.hasPicture,i.meshes>0&&!Yo}function uy(i){if(qr.tick(i),Jt===null)return;const t=Jt.stats();uf(t,vi.began),hn.connection(t),Xr.waits(t.state==="lost"?Ae.waiting:0),hn.where(qi(),he),t.hasPicture||t.state==="complete"?hn.opened():hn.opening("The land is on its way",Ad(t)),iy.tick(i,t.state==="complete"&&!vn.isAnyOpen,Fe.hasMoved),sy.update(t,i,Od.framesPerSecond,vn.isOpen("traffic"))}$i(Mn);jr();kl();lf();hn.opening(Ji?"Making the world":"Connecting",null);hn.status(Ji?"Opening":"Connecting","busy");Qi();Od.start();vi.open();window.talus={get engine(){return Jt},player:Fe,settings:Ee,builder:Ae,pick:to};
